#pragma once
/// All that a brush author needs; see brush.h for where to start.
#include <burin/plugin/brush.h>
#include <burin/plugin/cell.h>
#include <burin/plugin/entry.h>
#include <burin/plugin/error.h>
#include <burin/plugin/falloff.h>
#include <burin/plugin/frames.h>
#include <burin/plugin/ink.h>
#include <burin/plugin/lettering.h>
#include <burin/plugin/log.h>
#include <burin/plugin/noise.h>
#include <burin/plugin/params.h>
#include <burin/plugin/random.h>
#include <burin/plugin/sample_tiles.h>
#include <burin/plugin/shapes.h>
#include <burin/plugin/stamps.h>
#include <burin/plugin/tiling.h>
