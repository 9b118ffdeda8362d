#pragma once

#include "ros_messages/generated/structs.hpp"
