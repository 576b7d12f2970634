// OpenXR's own declarations, with those of its extensions for OpenGL on X11 and for the system's
// clock.
#pragma once

#include <ctime>

#include <epoxy/gl.h>
#include <epoxy/glx.h>
#include <openxr/openxr.h>
#include <openxr/openxr_platform.h>
