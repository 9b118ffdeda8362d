#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "config/reader.hpp"

namespace farrier::config::sample {

enum class Colour { kRed, kGreen, kBlue };

struct Wheel {
  double radius_m = 0.0;
  double pressure_Pa = 0.0;
};

struct Trailer {
  int axles = 0;
};

struct Lamp {
  double power_W = 5.0;
};

struct Cart {
  std::string name;
  double mass_kg = 0.0;
  double drag_Ns_m = 0.0;
  int seats = 0;
  bool brakes = false;
  Colour colour = Colour::kRed;
  std::vector<double> gears;
  std::vector<std::string> drivers;
  std::optional<Trailer> trailer;
  Named<Wheel> wheels;
  Named<std::string> roles;
  std::string owner;
  Lamp lamp;
  Named<Lamp> lanterns;
  Place place, roles_place;
};

inline void declare(Visitor& v, Wheel& w) {
  v.number("radius_m", w.radius_m, {0.1, 1}, "Radius of the wheel.");
  v.number("pressure_Pa", w.pressure_Pa, {1e5, 1e6}, Default{2e5}, "Pressure of the tyre.");
}

inline void declare(Visitor& v, Trailer& t) { v.integer("axles", t.axles, {1, 3}, "Number of axles."); }

inline void declare(Visitor& v, Lamp& l) {
  v.number("power_W", l.power_W, {1, 100}, Default{Lamp{}.power_W}, "Power of the lamp.");
}

inline void declare(Visitor& v, Cart& c) {
  constexpr std::array kColours = {Option<Colour>{"red", Colour::kRed}, Option<Colour>{"green", Colour::kGreen},
                                   Option<Colour>{"blue", Colour::kBlue}};
  v.here(c.place);
  v.name("name", c.name, 8, "Name of the cart.");
  v.number("mass_kg", c.mass_kg, {0.01, 1000}, "Mass of the cart.");
  v.number("drag_Ns_m", c.drag_Ns_m, {0, 100}, Default{5.0}, "Drag.");
  v.integer("seats", c.seats, {1, 8}, Default{2}, "Seats.");
  v.flag("brakes", c.brakes, Default{true}, "Whether it has brakes.");
  v.choice<Colour>("colour", c.colour, kColours, Default{Colour::kGreen}, "Paint.");
  v.numbers("gears", c.gears, {0.1, 10}, "Ratios.");
  v.names("drivers", c.drivers, "Who may drive.");
  v.group("trailer", c.trailer, "What it pulls.");
  v.groups("wheels", c.wheels, 8, "Wheels.");
  v.pairs("roles", c.roles, c.roles_place, 8, "Who does what.");
  v.name("owner", c.owner, 8, Default{"nobody"}, "Whose it is.");
  v.group("lamp", c.lamp, Defaults{}, "Its lamp.");
  v.groups("lanterns", c.lanterns, 8, Defaults{}, "What hangs on it.");
  v.check(c.drag_Ns_m < c.mass_kg, "drag_Ns_m", "must be below mass_kg");
}

inline const std::string kGood =
    "name: cart\n"                      // 1
    "mass_kg: 20\n"                     // 2
    "drivers: [ann, bob]\n"             // 3
    "wheels:\n"                         // 4
    "  left: {radius_m: 0.3}\n"         // 5
    "  right:\n"                        // 6
    "    radius_m: 0.4\n"               // 7
    "roles: {ann: front, bob: rear}\n"; // 8

/// The mistakes of the good text with `from` replaced by `to`, one per line.
inline std::string mistakes(const std::string& from, const std::string& to) {
  std::string text = kGood;
  const auto at = text.find(from);
  if (at == std::string::npos) {
    return "the sample has no " + from;
  }
  text.replace(at, from.size(), to);
  const auto cart = read_text<Cart>(text, "cart.yaml");
  return cart ? "" : to_string(cart.error());
}

/// The mistakes of the good text with lines added at the end (from line 9).
inline std::string mistakes_with(const std::string& more) {
  const auto cart = read_text<Cart>(kGood + more, "cart.yaml");
  return cart ? "" : to_string(cart.error());
}

}  // namespace farrier::config::sample
