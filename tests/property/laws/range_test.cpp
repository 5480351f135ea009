/// A law has a stress, or the run says where its range ended: no output of a run that ends well
/// holds a number that is none. Random states and random scenes of every law and assumption;
/// TLSPH_RANDOM_SCENES of them (default 30), the same in every run.

#include <cstdlib>
#include <sstream>

#include "property/sweeps.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/dynamics/measures.hpp"
#include "tlsph/io/hdf5.hpp"
#include "tlsph/simulation/simulation.hpp"

namespace tlsph::property {
namespace {

template <int D>
AnyLaw<D> law_of(Material material, double poisson) {
  material.constants[1] = poisson;
  return property::law_of<D>(material);
}

template <int D>
void expect_numbers_inside_the_range(const Material& material, std::uint64_t seed) {
  Random random(seed);
  int inside = 0;
  for (int n = 0; n < 2000; ++n) {
    const double poisson = -0.25 + 0.7499 * random();
    const Region<D> region{law_of<D>(material, poisson), density, {}};
    const auto H = random.tensor<D>(std::exp(3.0 * random()));
    const Tensor<D> P = pk1<D>(region.law, H);
    if (!(margin<D>(region.law, H) > 0.0)) continue;
    ++inside;
    const StressMeasures<D> stress = stress_measures<D>(region, H, P);
    EXPECT_TRUE(P.allFinite() && stress.cauchy.allFinite() && std::isfinite(stress.von_mises) &&
                std::isfinite(stress.pressure) && std::isfinite(energy<D>(region.law, H)) &&
                tangent<D>(region.law, H).allFinite())
        << "poisson " << poisson << ", H = " << H;
  }
  EXPECT_GT(inside, 500);
}

TEST(Range, OfALawHasNumbersOnly) {
  for (const Material& material : materials()) {
    SCOPED_TRACE(std::string(material.law) + " " + material.assumption);
    expect_numbers_inside_the_range<1>(material, 1);
    expect_numbers_inside_the_range<2>(material, 2);
  }
}

/// 1 + 2E_33 = 1 − 2ν E_11 vanishes at F_11 = √(1 + 1/ν), in a bar and in a sheet alike.
TEST(Range, OfStVenantKirchhoffEndsInUniaxialTension) {
  const double poisson = 0.4, end = std::sqrt(3.5);
  const Material material{"st-venant-kirchhoff", "stress"};
  for (const double stretch : {0.999 * end, 1.001 * end}) {
    const double E = 0.5 * (stretch * stretch - 1);
    Tensor<2> sheet = Tensor<2>::Zero();
    sheet(0, 0) = stretch - 1;
    sheet(1, 1) = std::sqrt(1 - 2 * poisson * E) - 1;
    if (stretch > end) sheet(1, 1) = -1 + 1e-3;

    EXPECT_EQ(margin<1>(law_of<1>(material, poisson), Tensor<1>(stretch - 1)) > 0, stretch < end);
    EXPECT_EQ(margin<2>(law_of<2>(material, poisson), sheet) > 0, stretch < end);
  }
  EXPECT_NE(range<2>(law_of<2>(material, poisson)).find("1.871"), std::string::npos);
}

/// f where the state has one, or what the error says.
template <int D, class Evaluate>
std::string failure_of(State<D>& state, const Evaluate& evaluate) {
  try {
    evaluate(state);
  } catch (const NumericalError& error) {
    EXPECT_GE(error.particle(), 0);
    EXPECT_EQ(error.time(), state.time);
    return error.what();
  }
  EXPECT_TRUE(state.H.allFinite() && state.P.allFinite() && state.f.allFinite());
  return "";
}

/// Bodies in homogeneous deformation that is disturbed: what the plain evaluation finds is what a
/// sweep finds, and what a look at all points finds.
TEST(Range, IsWatchedByEverySweep) {
  const std::vector<Variant> bodies = {{"interval", "stress-point", "", "", ""},
                                       {"jittered", "stress-point", "", "", ""},
                                       {"box", "variational", "", "wendland-c2", "2.5"}};
  Random random(17);
  int failures = 0, beyond = 0;
  for (const Variant& variant : bodies)
    discretised(scene_of(variant), [&]<int D>(Discretisation<D> body) {
      for (const Material& material : materials())
        for (int n = 0; n < 20; ++n) {
          const double poisson = -0.25 + 0.7499 * random();
          body.regions.front().law = law_of<D>(material, poisson);
          const auto A = random.tensor<D>(0.5 + 0.5 * random());
          const VectorField<D> u =
              affine<D>(body.particles.X, A, Vector<D>::Zero()) +
              random.field<D>(body.nodes(), 0.2 * body.spacing * (1.0 + random()));
          const VectorField<D> rest = VectorField<D>::Zero(body.nodes(), D);
          State<D> state = make_state<D>(body, u, rest);
          State<D> other = make_state<D>(body, u, rest);
          Sweep<D> sweep(body);

          const std::string plain =
              failure_of<D>(state, [&](State<D>& s) { evaluate<D>(body, s); });
          const std::string swept = failure_of<D>(other, [&](State<D>& s) { sweep.evaluate(s); });

          bool inside = true;
          for (Index s = 0; s < body.points.size(); ++s)
            inside = inside && margin<D>(body.regions.front().law, tensor_at<D>(state.H, s)) > 0.0;
          EXPECT_EQ(plain.empty(), inside) << plain;
          EXPECT_EQ(plain, swept);
          failures += plain.empty() ? 0 : 1;
          beyond += plain.starts_with("the range of the law") ? 1 : 0;
        }
    });
  EXPECT_GT(failures, 20);
  EXPECT_GT(beyond, 10);
}

/// A scene with what a law meets: stretched, struck, drawn and pressed bodies.
std::string random_scene(Random& random) {
  const auto chosen = [&](const std::vector<std::string>& words) {
    const auto k =
        static_cast<std::size_t>(0.5 * (random() + 1.0) * static_cast<double>(words.size()));
    return words[std::min(k, words.size() - 1)];
  };
  const auto chance = [&](double share) { return 0.5 * (random() + 1.0) < share; };
  const bool bar = chance(0.4);
  const std::string formulation =
      chosen({"stress-point", "variational", "consistent", "mirror", "thesis"});
  const bool ghosts = formulation == "mirror" || formulation == "thesis";
  const double size = std::exp(2.0 * random() - 1.5);  // of strains, 0.03 to 1.6
  std::ostringstream text;
  text << std::setprecision(6);
  const auto gradient = [&](double factor) {
    std::ostringstream list;
    list << (bar ? "{ gradient = [[" : "{ gradient = [[") << factor * size * random();
    if (!bar)
      list << ", " << factor * size * random() << "], [" << factor * size * random() << ", "
           << factor * size * random();
    list << "]] }";
    return list.str();
  };
  text << "dimension = " << (bar ? 1 : 2) << "\nformulation = \"" << formulation << "\"\n[body]\n"
       << (bar ? "shape = { interval = [0.0, 1.0] }\n"
               : "shape = { box = [[0.0, 0.0], [1.0, 0.8]] }\n")
       << "spacing = " << (bar ? 0.05 : 0.1) << "\n";
  if (!ghosts && chance(0.3)) text << "jitter = 0.2\n";
  text << "[material]\nlaw = \"" << chosen({"linear-elastic", "st-venant-kirchhoff", "neo-hookean"})
       << "\"\nassumption = \"" << chosen({"strain", "stress"})
       << "\"\nyoung = 1e6\npoisson = " << -0.25 + 0.7499 * random() << "\ndensity = 1000\n";
  if (!bar && ghosts)  // edges that may strain along themselves are refused
    text << "[[boundary]]\nwhere = \"bottom\"\nsymmetry = true\n"
         << "[[boundary]]\nwhere = \"top\"\nsymmetry = true\n";
  text << "[[boundary]]\nwhere = \"left\"\n"
       << (ghosts ? "fixed = true\n" : chosen({"fixed = true\n", "held = true\n"}));
  text << "[[boundary]]\nwhere = \"right\"\n"
       << (chance(0.5) ? "displacement = { x = { curve = \"" : "traction = { curve = \"");
  const bool moved = text.str().ends_with("x = { curve = \"");
  const double load = moved ? size : 5e5 * size;
  if (chance(0.5))
    text << "table\", time = [0, 0.02, 0.04], value = [0, " << load * random() << ", "
         << load * random() << "]";
  else
    text << "smooth-ramp\", rise = 0.03, amplitude = " << load * random();
  text << (moved ? " } }\n" : " }\n");
  text << "[initial]\n";
  if (!ghosts && chance(0.4)) text << "displacement = " << gradient(0.5) << "\n";
  if (chance(0.5)) text << "velocity = " << gradient(20.0) << "\n";
  text << "[time]\nend = 0.05\n[[probe]]\nat = " << (bar ? "[0.53]" : "[0.53, 0.31]")
       << "\nrecord = [\"displacement\", \"velocity\", \"acceleration\", \"deformation_gradient\", "
          "\"pk1\", \"cauchy\", \"pressure\", \"von_mises\"]\n[[probe]]\nat = "
       << (bar ? "[1.0]" : "[1.0, 0.8]")
       << "\nrecord = [\"acceleration\", \"cauchy\", \"von_mises\"]\n[output]\nframes = 3\n"
          "fields = [\"displacement\", \"velocity\", \"acceleration\", \"deformation_gradient\", "
          "\"pk1\", \"cauchy\", \"pressure\", \"von_mises\"]\n";
  return text.str();
}

void expect_numbers_in_text(const std::filesystem::path& path) {
  std::ifstream file(path);
  ASSERT_TRUE(file.good()) << path;
  std::string line;
  std::getline(file, line);  // the header
  while (std::getline(file, line))
    ASSERT_TRUE(line.find("nan") == std::string::npos && line.find("inf") == std::string::npos)
        << path << ": " << line;
}

void expect_numbers_in_group(const Hdf5File& file, const std::string& group) {
  for (const std::string& name : file.names(group))
    for (const double value : file.read_doubles(group + "/" + name).values)
      ASSERT_TRUE(std::isfinite(value)) << group << "/" << name;
}

void expect_numbers_in_summary(const Summary& s) {
  for (const double value : {s.dt, s.dt_critical, s.end_time, s.energy.kinetic, s.energy.elastic,
                             s.energy.external_work, s.energy.dissipated, s.energy.drift_relative,
                             s.linear_momentum_drift, s.angular_momentum_drift})
    ASSERT_TRUE(std::isfinite(value));
}

TEST(RandomScenes, EndWellWithNumbersOnlyOrSayWhereTheyEnd) {
  const char* wanted = std::getenv("TLSPH_RANDOM_SCENES");
  const long scenes = wanted == nullptr ? 30 : std::atol(wanted);
  const std::filesystem::path out =
      std::filesystem::temp_directory_path() / ("tlsph_range_" + std::to_string(::getpid()));
  Random random(2024);
  long ended_well = 0, lost = 0, refused = 0;
  for (long n = 0; n < scenes; ++n) {
    const std::string text = random_scene(random);
    SCOPED_TRACE(text);
    RunOptions options;
    options.out = out;
    options.threads = 1;
    try {
      expect_numbers_in_summary(run(read_scene_text(text, "random.toml", {}), options));
      expect_numbers_in_text(out / "probes.csv");
      const Hdf5File file = Hdf5File::open_read_only(out / "run.h5");
      expect_numbers_in_group(file, "/frames");
      expect_numbers_in_group(file, "/series");
      ++ended_well;
    } catch (const NumericalError& error) {
      EXPECT_NE(std::string(error.what()).find("t = "), std::string::npos) << error.what();
      EXPECT_GE(error.particle(), 0) << error.what();
      ++lost;
    } catch (const InputError& error) {
      ++refused;
    }
    std::filesystem::remove_all(out);
    if (testing::Test::HasFailure()) break;
  }
  RecordProperty("ended_well", std::to_string(ended_well));
  RecordProperty("lost", std::to_string(lost));
  EXPECT_GT(ended_well, scenes / 4);
  EXPECT_LT(refused, scenes / 2);
  std::printf("%ld scenes: %ld end well, %ld are lost, %ld are refused\n", scenes, ended_well, lost,
              refused);
}

}  // namespace
}  // namespace tlsph::property
