#include "tlsph/core/team.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <thread>
#include <vector>

#include "tlsph/core/parallel.hpp"

namespace tlsph {
namespace {

class TeamOf : public testing::TestWithParam<int> {};

TEST_P(TeamOf, MakesEveryPartOnceAndPhasesInOrder) {
  const int threads = GetParam();
  for (const int parts : {1, 2, 3, 7, 64, 1000})
    for (int round = 0; round < 200; ++round) {
      std::vector<int> first(static_cast<std::size_t>(parts), 0), second = first;
      TeamChoice choice;
      in_parts(
          choice, 1.0, threads, parts, [&](int part) { ++first[static_cast<std::size_t>(part)]; },
          [&](int part) {
            // Reads what any thread has written in the phase before.
            second[static_cast<std::size_t>(part)] = std::accumulate(first.begin(), first.end(), 0);
          });
      ASSERT_EQ(first, std::vector<int>(first.size(), 1));
      ASSERT_EQ(second, std::vector<int>(first.size(), parts));
    }
}

INSTANTIATE_TEST_SUITE_P(Threads, TeamOf, testing::Values(1, 2, 3, 9));

TEST(Team, IsLentToOneAtATime) {
  std::vector<double> sums(4, 0.0);
  std::vector<std::thread> users;
  for (double& sum : sums)
    users.emplace_back([&sum] {
      TeamChoice choice;
      for (int round = 0; round < 2000; ++round) {
        std::array<double, 3> part{};
        in_parts(choice, 1.0, 2, 3, [&](int p) {
          // A loop within a part has no team of its own.
          TeamChoice inner;
          in_parts(inner, 1.0, 2, 2, [&](int q) { part[static_cast<std::size_t>(p)] += q; });
        });
        sum += part[0] + part[1] + part[2];
      }
    });
  for (std::thread& user : users) user.join();

  EXPECT_EQ(sums, std::vector<double>(4, 3.0 * 2000));
}

TEST(Team, SumsDoNotDependOnTheThreads) {
  const auto term = [](Index row) { return std::sin(static_cast<double>(row)); };
  const int before = omp_get_max_threads();
  std::vector<double> sums;
  for (const int threads : {1, 2, 3, 8}) {
    omp_set_num_threads(threads);
    sums.push_back(sum_rows(12'345, term));
  }
  omp_set_num_threads(before);

  EXPECT_EQ(sums, std::vector<double>(4, sums.front()));
}

}  // namespace
}  // namespace tlsph
