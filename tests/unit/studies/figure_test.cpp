#include "tlsph/studies/figure.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "study_folder.hpp"

namespace tlsph {
namespace {

class FigureOf : public StudyFolder {
 protected:
  void TearDown() override {
    unsetenv("TLSPH_PLOT");
    StudyFolder::TearDown();
  }
};

TEST_F(FigureOf, DataIsDrawnBesideIt) {
  const auto script = write("plot.py",
                            "import pathlib, sys\n"
                            "pathlib.Path(sys.argv[4]).write_text(' '.join(sys.argv[1:4]))\n");
  setenv("TLSPH_PLOT", script.c_str(), 1);
  const auto data = write("some data.csv", "");

  const Figure figure = draw_figure("convergence", data);

  ASSERT_TRUE(figure.drawn);
  EXPECT_EQ(figure.file, folder / "some data.png");
  EXPECT_EQ(read(figure.file), "convergence " + data.string() + " --out");
}

TEST_F(FigureOf, NothingDrawnSaysHow) {
  const auto failing = write("plot.py", "import sys\nsys.exit(2)\n");
  for (const std::string& script : {failing.string(), std::string("/no/such/plot.py")}) {
    setenv("TLSPH_PLOT", script.c_str(), 1);

    const Figure figure = draw_figure("convergence", "out/convergence.csv");

    EXPECT_FALSE(figure.drawn);
    EXPECT_EQ(figure.command, "python3 " + script + " convergence out/convergence.csv");
  }
}

}  // namespace
}  // namespace tlsph
