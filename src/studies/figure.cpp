#include "tlsph/studies/figure.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <optional>

#include "process.hpp"

namespace tlsph {
namespace {

namespace fs = std::filesystem;

/// The value of an environment variable that is set and not empty.
std::optional<fs::path> chosen_by(const char* variable) {
  const char* value = std::getenv(variable);
  if (value == nullptr || *value == '\0') return std::nullopt;
  return value;
}

/// The script, empty if there is none.
fs::path plot_script() {
  if (const auto chosen = chosen_by("TLSPH_PLOT")) return *chosen;
  const fs::path folder = validation_folder();
  return folder.empty() ? folder : folder / "plot.py";
}

}  // namespace

fs::path validation_folder() {
  if (const auto chosen = chosen_by("TLSPH_VALIDATION")) return *chosen;
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  for (const fs::path& candidate : {program.parent_path().parent_path() / "share/tlsph/validation",
                                    fs::path(TLSPH_VALIDATION_FOLDER)})
    if (fs::is_regular_file(candidate / "plot.py", ignored)) return candidate;
  return {};
}

Figure draw_figure(const std::string& kind, const fs::path& data, const fs::path& file) {
  const fs::path beside = fs::path(data).replace_extension(".png");
  Figure figure;
  figure.file = file.empty() ? beside : file;
  const fs::path script = plot_script();
  figure.command =
      fmt::format("python3 {} {} {}", script.empty() ? "validation/plot.py" : script.string(), kind,
                  data.string());
  if (figure.file != beside) figure.command += " --out " + figure.file.string();
  if (script.empty()) return figure;
  // -B: no byte code beside the scripts, which may lie where only the system writes.
  figure.drawn = run_process({python(), "-B", script.string(), kind, data.string(), "--out",
                              figure.file.string()}) == 0;
  return figure;
}

}  // namespace tlsph
