// Groups of durations.
#include "learn/clusters.hpp"

#include <string>
#include <vector>

#include "learn_support.hpp"

namespace symplant::test {
namespace {

std::vector<learn::Sample> samples(const std::vector<int>& durations) {
  std::vector<learn::Sample> all;
  for (const int duration : durations) all.push_back({duration * kMilli, 0, 0});
  return all;
}

/// "0-3 3-5; outliers 5": ranges of indexes, then outliers.
std::string clusters(const std::vector<int>& durations, int resolution = 0) {
  const learn::Clusters found = learn::clusters_of(samples(durations), resolution * kMilli);
  std::string text;
  for (const learn::Cluster& cluster : found.kept) {
    text += (text.empty() ? "" : " ") + std::to_string(cluster.begin) + "-" + std::to_string(cluster.end);
  }
  if (!found.outliers.empty()) text += "; outliers";
  for (const std::size_t i : found.outliers) text += " " + std::to_string(i);
  return text;
}

TEST_CASE("A gap of over 30 % of the median divides durations") {
  CHECK(clusters({800, 810, 1050, 1060}) == "0-4");
  CHECK(clusters({800, 810, 1200, 1210}) == "0-2 2-4");
  CHECK(clusters({1000, 1000, 1000, 1300, 1300}) == "0-5");
  CHECK(clusters({1000, 1000, 1000, 1301, 1301}) == "0-3 3-5");
}

TEST_CASE("A gap under 5 resolutions does not divide durations") {
  CHECK(clusters({100, 100, 100, 340, 340}, 50) == "0-5");
  CHECK(clusters({100, 100, 100, 350, 350}, 50) == "0-3 3-5");
}

TEST_CASE("A duration alone is an outlier, at either end") {
  CHECK(clusters({100, 800, 810, 820, 3200}) == "1-4; outliers 0 4");
}

TEST_CASE("A group of under 5 % is one of outliers") {
  std::vector<int> durations(38, 800);
  durations.insert(durations.end(), {1400, 1400});
  CHECK(clusters(durations) == "0-38 38-40");
  durations.insert(durations.begin(), 800);
  CHECK(clusters(durations) == "0-39; outliers 39 40");
}

TEST_CASE("Durations that are all alone are one group") {
  CHECK(clusters({800}) == "0-1");
  CHECK(clusters({100, 800, 3000}) == "0-3");
  CHECK(clusters({}).empty());
}

}  // namespace
}  // namespace symplant::test
