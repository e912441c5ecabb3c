// The map of passage_map.h as text and pixels.
#pragma once

#include <string>

#include <taut/search/passage_map.h>

namespace taut {

/// A FeatureCollection of the faces, each with `radius` (null when unbounded) and, where a gate limits it, its name.
std::string passage_map_geojson(const std::vector<PassageFace>& faces, const Gates& gates);

/// A row a line, from the top, cells separated by commas.
std::string passage_raster_csv(const PassageRaster& raster);

/// A grey map (P5), 255 being the largest radius; a comment says what one step is.
std::string passage_raster_pgm(const PassageRaster& raster);

}  // namespace taut
