// What the peers in C++ share: the data sets of test/data/geometry (its README says what they hold), the clock
// and the output. Each peer prints one JSON object: for each kind of query the nanoseconds of processor time
// that one took, and all answers.
#pragma once

#include <ctime>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace bench {

using Row = std::vector<long long>;

[[noreturn]] inline void fail(const std::string& message) {
  std::cerr << message << "\n";
  std::exit(2);
}

inline std::vector<Row> rows(const std::string& path) {
  std::ifstream file(path);
  if (!file) fail(path + ": cannot be read");
  std::vector<Row> all;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    Row row;
    for (long long x; words >> x;) row.push_back(x);
    if (!row.empty()) all.push_back(row);
  }
  return all;
}

struct Solid {
  std::vector<std::array<long long, 3>> vertices;
  std::vector<std::vector<int>> faces;  // counter-clockwise from outside
};

inline Solid solid(const std::string& path) {
  const auto all = rows(path);
  const size_t n = all.at(0).at(0), m = all.at(0).at(1);
  Solid s;
  for (size_t i = 0; i < n; i++) s.vertices.push_back({all.at(1 + i).at(0), all[1 + i].at(1), all[1 + i].at(2)});
  for (size_t i = 0; i < m; i++) {
    const Row& row = all.at(1 + n + i);
    s.faces.emplace_back(row.begin() + 1, row.end());
  }
  return s;
}

using Triple = std::array<long long, 3>;
using Quaternion = std::array<long long, 4>;

// A is turned by qa; B is turned by qb and then displaced by near/near_denominator. `far` and `velocity` are of
// the cast, which sets of kissing pairs do not have.
struct Case {
  Quaternion qa, qb;
  Triple near;
  long long near_denominator;
  bool casts;
  Triple far, velocity;
};

inline long long norm2(const Quaternion& q) { return q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]; }

inline std::vector<Case> cases(const std::string& path) {
  const auto all = rows(path);
  std::vector<Case> found;
  for (size_t i = 1; i < all.size(); i++) {
    const Row& r = all[i];
    auto triple = [&](int k) { return Triple{r.at(k), r.at(k + 1), r.at(k + 2)}; };
    auto turn = [&](int k) { return Quaternion{r.at(k), r.at(k + 1), r.at(k + 2), r.at(k + 3)}; };
    if (r.size() == 7)
      found.push_back({turn(3), turn(3), triple(0), norm2(turn(3)), false, {}, {}});
    else
      found.push_back({{1, 0, 0, 0}, turn(9), triple(0), 1, true, triple(3), triple(6)});
  }
  return found;
}

// |q|^2 times the rotation matrix of q.
inline std::array<Triple, 3> matrix(const Quaternion& q) {
  const long long w = q[0], x = q[1], y = q[2], z = q[3];
  return {Triple{w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)},
          Triple{2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)},
          Triple{2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z}};
}

// The vertices of the turned solid, times |q|^2.
inline std::vector<Triple> turned(const Solid& s, const Quaternion& q) {
  const auto m = matrix(q);
  std::vector<Triple> found;
  for (const auto& v : s.vertices) {
    Triple p;
    for (int i = 0; i < 3; i++) p[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    found.push_back(p);
  }
  return found;
}

// Processor time of this process, in nanoseconds.
inline double clock() {
  timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return t.tv_sec * 1e9 + t.tv_nsec;
}

// Keeps results alive.
inline volatile long long sink = 0;

class Output {
 public:
  explicit Output(const std::string& program) { std::cout << "{\"program\":\"" << program << "\",\"rows\":["; }
  ~Output() { std::cout << "]}\n"; }

  // run(i) is query i and gives a number, say(number) its answer in words. The time is the mean over as many
  // passes through all n pairs as take 0.1 s, after one pass to warm up.
  template <class Run, class Say>
  void row(const char* query, const std::string& name, size_t n, Run run, Say say) {
    auto pass = [&] {
      for (size_t i = 0; i < n; i++) sink = sink + static_cast<long long>(run(i));
    };
    pass();
    const double start = clock();
    double elapsed = 0;
    long passes = 0;
    do {
      pass();
      passes++;
      elapsed = clock() - start;
    } while (elapsed < 1e8);
    char ns[40];
    std::snprintf(ns, sizeof ns, "%.1f", elapsed / (double(passes) * n));
    std::cout << (first_ ? "" : ",") << "{\"query\":\"" << query << "\",\"name\":\"" << name << "\",\"ns\":" << ns
              << ",\"answers\":[";
    for (size_t i = 0; i < n; i++) std::cout << (i ? "," : "") << '"' << say(run(i)) << '"';
    std::cout << "]}";
    first_ = false;
  }

 private:
  bool first_ = true;
};

inline const char* meet(double yes) { return yes != 0 ? "meet" : "apart"; }

// A negative time means never.
inline std::string hit(double time) {
  char text[40];
  std::snprintf(text, sizeof text, "hit %.17g", time);
  return time < 0 ? "never" : text;
}

}  // namespace bench
