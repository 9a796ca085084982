// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "odeum/why/inquiry.hpp"

namespace odeum::why {
namespace {

/// Steps this much longer under a tolerance a hundred times as loose: a method of order 20
/// has 1.25.
constexpr double follows_tolerance = 1.15;
/// From here on an eigenvalue is taken to be at the edge: methods that double steps, and those of
/// several orders, have another edge than their steps of one length.
constexpr double at_the_edge = 0.4;
/// Without a known edge, in h |lambda|.
constexpr double beyond_accuracy = 0.4, most_of_a_region = 50;
constexpr double least_share = 0.1;

double rate_of(const Inquiry& q, const std::vector<double>& f) {
  double rate = 0;
  for (std::size_t i = 0; i < f.size(); ++i) {
    const double least = q.adaptive() ? q.run.request.tolerance.absolute(i) : 0;
    if (q.sizes[i] > least) rate = std::max(rate, std::abs(f[i]) / q.sizes[i]);
  }
  return rate;
}

/// The rate of the solution at a time: at the state of the trusted run next to it, whose fast parts
/// are at rest to a hundredth of the tolerance; else at the run's own.
double rate_at(const Inquiry& q, const Moment& at) {
  const Moment* nearest = &at;
  if (q.trusted) {
    const std::vector<Moment>& known = q.trusted->moments;
    nearest = &*std::ranges::min_element(known, [&](const Moment& a, const Moment& b) {
      return std::abs(a.t - at.t) < std::abs(b.t - at.t);
    });
  }
  return rate_of(q, slope(q.c, nearest->t, nearest->y));
}

/// The eigenvalue that uses most of the region.
void find_binding(Inquiry& q, Sample& s) {
  s.binding = s.spectrum.fastest;
  // The outermost ones: few directions are measured.
  for (const std::complex<double>& z : s.spectrum.all) {
    if (std::abs(z) < 0.2 * std::abs(s.spectrum.fastest) || z.imag() < 0) continue;
    if (z.real() > 1e-6 * std::abs(z)) continue;
    const double used = s.at.h * std::abs(z) / q.region.edge(z);
    if (std::isnan(used) || used <= s.used) continue;
    s.used = used;
    s.binding = z;
  }
}

double fastness(const Sample& s) { return std::abs(s.binding); }

std::optional<Cause> cause_of(const Inquiry& q, const Sample& s) {
  if (q.found(Cause::sliding) && s.at.t + 2 * s.at.h >= q.kinks.front().t) return Cause::sliding;
  for (const Kink& kink : q.kinks)
    if (std::abs(kink.t - s.at.t) <= std::max(2 * s.at.h, q.kink_reach)) return Cause::kink;
  // Runs that have parted say little: the edge binds where a looser run takes as many steps in all,
  // and an eigenvalue is far beyond what the solution shows.
  if (q.parted) {
    constexpr double much = 10, near_the_edge = 0.7;
    const bool as_many = static_cast<double>(q.run.steps()) <
                         follows_tolerance * static_cast<double>(q.looser->steps());
    return as_many && s.used > near_the_edge && fastness(s) > much * s.rate ? Cause::stability
                                                                            : Cause::accuracy;
  }
  // Where no looser run got to, at the very edge.
  if (std::isnan(s.looser))
    return s.used > 0.7 && s.used < 1.4 ? std::optional(Cause::stability) : std::nullopt;
  if (s.looser > follows_tolerance) return Cause::accuracy;
  if (s.used > at_the_edge) return Cause::stability;
  // Without a known edge: within what regions have, where another solver's steps are much longer.
  const double product = s.at.h * std::abs(s.binding);
  const bool others_pass = std::ranges::any_of(q.others, [&](const Run& other) {
    return s.at.t < other.ends.back() && other.step_at(s.at.t) > 3 * s.at.h;
  });
  if (std::isnan(s.used) && product > beyond_accuracy && product < most_of_a_region && others_pass)
    return Cause::stability;
  return {};
}

template <class Key, class Number>
Key key_of_most(const std::map<Key, Number>& numbers) {
  return std::ranges::max_element(numbers, {}, [](const auto& each) { return each.second; })->first;
}

/// The component whose error a single step has most of, at most of the samples.
std::string deciding_component(const Inquiry& q) {
  constexpr std::size_t most = 16;
  std::vector<const Sample*> chosen;
  for (const Sample& s : q.samples)
    if (s.cause == Cause::accuracy) chosen.push_back(&s);
  const std::size_t apart = 1 + chosen.size() / most;
  std::map<std::size_t, int> votes;
  for (std::size_t k = 0; k < chosen.size() && q.left() > 0.2 * q.seconds; k += apart) {
    const std::vector<double> error =
        step_error(q.c, q.why.solver, chosen[k]->at, q.run.request.tolerance, Mode::adaptive);
    if (!error.empty()) ++votes[std::ranges::max_element(error) - error.begin()];
  }
  return votes.empty() ? std::string() : q.names[key_of_most(votes)];
}

/// The middle one of a number of the samples, of those where it is known.
template <class NumberOf>
double middle(const std::vector<const Sample*>& samples, const NumberOf& number_of) {
  std::vector<double> values;
  for (const Sample* s : samples) values.push_back(std::invoke(number_of, *s));
  std::erase_if(values, [](double x) { return std::isnan(x); });
  if (values.empty()) return nan;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

/// The most frequent component of the fastest eigenvalue, by steps.
std::optional<std::size_t> who(const std::vector<const Sample*>& samples) {
  std::map<std::size_t, double> weights;
  for (const Sample* s : samples)
    if (s->spectrum.component) weights[*s->spectrum.component] += s->weight;
  return weights.empty() ? std::nullopt : std::optional(key_of_most(weights));
}

Segment segment_of(const Inquiry& q, const std::vector<const Sample*>& samples, double to) {
  std::map<std::optional<Cause>, double> causes;
  Segment segment{.from = samples.front()->at.t, .to = to};
  for (const Sample* s : samples) {
    causes[s->cause] += s->weight;
    segment.steps += s->weight;
  }
  segment.cause = key_of_most(causes);
  segment.h = middle(samples, [](const Sample& s) { return s.at.h; });
  segment.fastest = middle(samples, fastness);
  segment.rate = middle(samples, &Sample::rate);
  segment.used = middle(samples, &Sample::used);
  if (const auto component = who(samples)) segment.component = q.names[*component];
  return segment;
}

/// The segments of one cause after the other; one with less than `least` of the steps joins the one
/// before.
std::vector<Segment> segments_of(const Inquiry& q, double least) {
  std::vector<std::vector<const Sample*>> parts;
  double total = 0;
  for (const Sample& s : q.samples) total += s.weight;
  double held = 0;
  for (const Sample& s : q.samples) {
    const bool same = !parts.empty() && (s.cause == parts.back().front()->cause || !(s.at.h > 0));
    if (!same && (parts.empty() || held >= least * total)) {
      parts.emplace_back();
      held = 0;
    }
    parts.back().push_back(&s);
    held += s.weight;
  }
  if (parts.size() > 1 && held < least * total) {
    std::vector<const Sample*>& before = parts[parts.size() - 2];
    before.insert(before.end(), parts.back().begin(), parts.back().end());
    parts.pop_back();
  }
  std::vector<Segment> segments;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const double to = k + 1 < parts.size() ? parts[k + 1].front()->at.t : q.samples.back().at.t;
    const Segment next = segment_of(q, parts[k], to);
    if (segments.empty() || segments.back().cause != next.cause) {
      segments.push_back(next);
      continue;
    }
    // The smaller part was of another cause at first.
    parts[k].insert(parts[k].begin(), parts[k - 1].begin(), parts[k - 1].end());
    segments.back() = segment_of(q, parts[k], to);
  }
  return segments;
}

std::string stability_text(const Inquiry& q, const std::vector<const Sample*>& bound) {
  const auto decay_of = [](const Sample& s) { return std::abs(s.binding.real()); };
  const double fastest = middle(bound, fastness), decay = middle(bound, decay_of);
  std::string text = fmt::format(
      "{} {} at {:.2g} per unit of time, the solution changes at {:.2g}", q.name_of(who(bound)),
      decay > 0.5 * fastest ? "decays" : "oscillates", fastest, middle(bound, &Sample::rate));
  if (const double share = middle(bound, &Sample::used); !std::isnan(share))
    text += fmt::format(", and a step takes {:.2g} of the stability region", share);
  return text;
}

}  // namespace

void sample(Inquiry& q, const Run& along, double h) {
  const std::size_t n = q.c.y0.size();
  // An eigenvalue problem takes some n^3.
  const double room = 4e6 / std::pow(static_cast<double>(std::max<std::size_t>(n, 27)), 3);
  const auto most = static_cast<std::size_t>(std::clamp(room, 6.0, 200.0));
  const std::size_t apart = std::max<std::size_t>(1, along.moments.size() / most);
  const double until = q.left() - 0.25 * q.seconds;
  q.samples.clear();
  for (std::size_t k = 0; k < along.moments.size(); k += apart) {
    constexpr std::size_t least = 4;  // whatever time is left
    if (q.samples.size() >= least && q.left() < until) break;
    Sample s{.at = along.moments[k]};
    const std::vector<double> f = slope(q.c, s.at.t, s.at.y);
    if (!is_finite(f.data(), n)) continue;
    if (h > 0)
      s.at.h = h;
    else if (&along != &q.run)
      s.at.h = q.run.step_at(s.at.t);
    s.spectrum = spectrum_at(q.c, s.at.t, s.at.y, q.sizes, q.trust_jacobian);
    find_binding(q, s);
    q.samples.push_back(std::move(s));
  }
  for (std::size_t k = 0; k < q.samples.size(); ++k) {
    const auto step = [&](std::size_t at) {
      return h > 0 ? (q.samples[at].at.t - q.c.t0) / h : static_cast<double>(q.samples[at].at.step);
    };
    const double before = k == 0 ? step(0) : 0.5 * (step(k - 1) + step(k));
    const double all =
        h > 0 ? (along.ends.back() - q.c.t0) / h : static_cast<double>(along.steps());
    const double after = k + 1 == q.samples.size() ? all : 0.5 * (step(k) + step(k + 1));
    q.samples[k].weight = after - before;
  }
}

void compare_samples(Inquiry& q) {
  // Where both have parted, their steps at one time are those of different states.
  constexpr double parted = 5 * far_off;
  q.parted = false;
  for (std::size_t i = 0; q.looser && q.looser->ok() && q.run.ok() && i < q.sizes.size(); ++i) {
    // A component below its absolute tolerance has the size that steps give it.
    const double size = q.sizes[i], apart = std::abs(q.looser->end()[i] - q.run.end()[i]);
    const bool held = q.adaptive() && size > q.looser->request.tolerance.absolute(i);
    q.parted = q.parted || (held && !(apart <= parted * size));
  }
  for (Sample& s : q.samples) {
    s.rate = rate_at(q, s.at);
    if (!q.looser || !(s.at.t < q.looser->ends.back())) continue;
    const auto [from, to] = q.run.around(s.at.t);
    s.looser = q.run.steps_in(from, to) / q.looser->steps_in(from, to);
    if (q.looser_by < 1) s.looser = 1 / s.looser;
  }
}

void make_segments(Inquiry& q) {
  constexpr std::size_t most_rows = 12;
  double least = 0.01;
  do q.why.segments = segments_of(q, least);
  while (q.why.segments.size() > most_rows && (least *= 2) < 0.5);
  std::vector<double> times = q.run.trace.times;
  std::ranges::sort(times);
  // Events are found by more runs over the same steps, which the counts leave out.
  const double part = q.run.outcome.events.empty() || times.empty()
                          ? 1
                          : static_cast<double>(q.run.outcome.counters.rhs_evaluations) /
                                static_cast<double>(times.size());
  for (Segment& segment : q.why.segments) {
    const auto noted =
        std::ranges::upper_bound(times, segment.to) - std::ranges::lower_bound(times, segment.from);
    segment.evaluations = std::lround(part * static_cast<double>(noted));
  }
}

void share_out(Inquiry& q) {
  double total = 0;
  for (Sample& s : q.samples) {
    s.cause = cause_of(q, s);
    total += s.weight;
  }
  if (q.samples.empty()) return;
  make_segments(q);
  for (const Cause cause : {Cause::stability, Cause::accuracy}) {
    std::vector<const Sample*> bound;
    double share = 0;
    for (const Sample& s : q.samples) {
      if (s.cause != cause) continue;
      bound.push_back(&s);
      share += s.weight / total;
    }
    if (share < least_share) continue;
    if (cause == Cause::stability) {
      q.add(cause, share, bound.front()->at.t, stability_text(q, bound));
      continue;
    }
    const double longer = middle(bound, &Sample::looser);
    const std::string component = deciding_component(q);
    q.add(cause, share, bound.front()->at.t,
          fmt::format("{}under {} the tolerance they are {:.2g} times as long",
                      component.empty() ? "" : component + " has the largest error of a step; ",
                      q.looser_by > 1 ? "100 times" : "a hundredth of",
                      q.looser_by > 1 ? longer : 1 / longer));
  }
}

}  // namespace odeum::why
