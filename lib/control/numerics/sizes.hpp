#pragma once

/// Numbers of states of the models that controllers are designed for: a load cell's model has three, delays and an
/// integrator add to it, and tests use two. X(N) instantiates a template for each.
#define FARRIER_FOR_EACH_SIZE(X) X(2) X(3) X(4) X(5) X(6)
