#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include <ceres/jet.h>

#include "diagnosis/model/simulator.hpp"

namespace farrier::diagnosis {

/// A number with its derivatives by the lanes of one simulation.
using Jet = ceres::Jet<double, static_cast<int>(Simulator::kLanes)>;

/// The number of a model at `place`, with derivative 1 in its lane if it has one.
inline Jet jet_at(std::size_t place, double value, const std::vector<std::size_t>& lanes) {
  Jet jet(value);
  if (const auto lane = std::ranges::find(lanes, place); lane != lanes.end()) {
    jet.v[lane - lanes.begin()] = 1.0;
  }
  return jet;
}

/// The nominal factors of a model.
inline std::array<Jet, kNominals> factor_jets(const Model& model, const std::vector<std::size_t>& lanes) {
  std::array<Jet, kNominals> factors;
  for (std::size_t i = 0; i < kNominals; ++i) {
    factors[i] = jet_at(i, model.factors[i], lanes);
  }
  return factors;
}

/// The numbers of a model's effects, places from kNominals on.
inline EffectNumbers<Jet> effect_jets(const Model& model, const std::vector<std::size_t>& lanes) {
  EffectNumbers<Jet> effects;
  std::size_t place = kNominals;
  for (const Model::Effect& effect : model.effects) {
    std::vector<Jet> fitted;
    for (const double value : effect.fitted) {
      fitted.push_back(jet_at(place++, value, lanes));
    }
    effects.emplace_back(effect.id, std::move(fitted));
  }
  return effects;
}

/// Values of what was simulated; `jacobian` gets rows of lanes.size() derivatives.
inline std::vector<double> values_and_jacobian(const std::vector<Jet>& jets, std::size_t lanes,
                                               std::vector<double>& jacobian) {
  std::vector<double> values;
  values.reserve(jets.size());
  jacobian.resize(jets.size() * lanes);
  for (std::size_t i = 0; i < jets.size(); ++i) {
    values.push_back(jets[i].a);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      jacobian[i * lanes + lane] = jets[i].v[static_cast<Eigen::Index>(lane)];
    }
  }
  return values;
}

}  // namespace farrier::diagnosis
