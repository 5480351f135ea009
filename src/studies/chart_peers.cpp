#include "chart_peers.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "peers.hpp"
#include "tlsph/scene/names.hpp"
#include "tlsph/studies/chart_search.hpp"

namespace tlsph {
namespace {

constexpr std::size_t repetitions = 3;

/// Of its next run: most of a short one is its start, which does not grow until it is seen to.
double next_cost(const std::vector<Measured>& runs, double spacing, int dimension) {
  const double before = runs.size() > 1 ? runs[runs.size() - 2].setup : runs.back().setup;
  const double growth = std::clamp(runs.back().setup / before, 1.0, 10.0);
  return growth * runs.back().setup + predict(runs, spacing, dimension).stepping;
}

/// What the scene allows of law and step and the peer, by its first answer, can be given.
std::vector<PeerVariant> others(const PeerVariant& own, const ChartPoint& first,
                                const ChartVariation& variation) {
  std::vector<std::string> laws = {""};
  std::vector<double> shares = {own.share};
  const std::string linear(name_of(LawName::linear_elastic));
  if (!first.law.empty() && first.law != linear && !variation.linear.empty())
    laws.push_back(linear);
  if (first.step_share && !variation.shares.empty() && variation.own_share < largest_share)
    shares.push_back(largest_share);
  std::vector<PeerVariant> all;
  for (const std::string& law : laws)
    for (const double share : shares)
      if (!law.empty() || share != own.share)
        all.push_back({own.script,
                       own.script + variant_label(!law.empty(), share, variation.own_share), share,
                       law});
  return all;
}

/// A variant of a peer at one spacing after the other for half of its share of the time that is
/// left; then its times once more.
class Ladder {
 public:
  Ladder(const ChartPeers& study, double all_until) : study_(study), all_until_(all_until) {}

  /// `sharers` of the time, this one among them. The first run of a peer may take all of it: a slow
  /// peer has one point; it also tells which variants there are, and share the time of their peer.
  std::vector<PeerVariant> run(const PeerVariant& variant, double sharers, bool own) {
    const double begin = study_.spent();
    double share = std::max(0.0, all_until_ - begin) / sharers;
    std::vector<PeerVariant> more;
    const std::size_t first = study_.table.points.size();
    std::vector<Measured> runs;
    for (const double spacing : study_.plan.ladder) {
      const double cost =
          runs.empty() ? 0.0 : next_cost(runs, spacing, study_.plan.scene.dimension);
      if (!runs.empty() && study_.spent() + cost > begin + 0.5 * share) break;
      const double before = study_.spent();
      PeerRun run = call(variant, spacing, runs.empty() && own ? all_until_ : begin + share);
      if (!run.unable.empty()) {
        if (runs.empty()) study_.table.notes.push_back(run.unable);
        break;
      }
      ChartPoint& point = run.point;
      point.setup_seconds = std::max(0.0, study_.spent() - before - point.time());
      runs.push_back({spacing, point.setup_seconds, point.time(), point.errors});
      if (runs.size() == 1 && own) {
        more = others(variant, point, study_.variation);
        share /= static_cast<double>(more.size() + 1);
      }
      study_.add(std::move(point));
    }
    repeat(variant, first, begin + share);
    return more;
  }

 private:
  void repeat(const PeerVariant& variant, std::size_t first, double until) const {
    for (std::size_t round = 1; round < repetitions; ++round)
      for (std::size_t k = first; k < study_.table.points.size(); ++k) {
        ChartPoint& point = study_.table.points[k];
        if (study_.spent() + point.setup_seconds + point.time() > until) continue;
        const PeerRun again = call(variant, point.spacing, until);
        if (again.unable.empty()) point.seconds.push_back(again.point.time());
      }
  }

  [[nodiscard]] PeerRun call(const PeerVariant& variant, double spacing, double until) const {
    study_.show(fmt::format("{} at {:.4g} m", variant.label, spacing));
    return run_peer(variant, study_.plan.scene, spacing, study_.table, study_.options.out / "peers",
                    until - study_.spent(), study_.options.stop_requested);
  }

  const ChartPeers& study_;
  double all_until_;
};

}  // namespace

void ChartPeers::run(double until) const {
  Ladder ladder(*this, until);
  for (std::size_t k = 0; k < request.peers.size(); ++k) {
    const auto after = static_cast<double>(request.peers.size() - k) - 1.0;
    const double own_part = std::max(0.0, until - spent()) / (after + 1.0);
    const double mine_until = spent() + own_part;
    const std::vector<PeerVariant> more = ladder.run(
        {request.peers[k], request.peers[k], variation.own_share, ""}, after + 1.0, true);
    Ladder mine(*this, mine_until);
    for (std::size_t m = 0; m < more.size(); ++m)
      (void)mine.run(more[m], static_cast<double>(more.size() - m), false);
  }
}

}  // namespace tlsph
