#include "gdal/drivers.h"

#include <cpl_conv.h>
#include <cpl_http.h>
#include <gdal_priv.h>
#include <ogr_srs_api.h>
#include <ogrsf_frmts.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

extern "C" char** environ;

namespace thiessen {
namespace {

constexpr std::array option_prefixes = {"GDAL_",
                                        "OGR_",
                                        "CPL_",
                                        "OSR_",
                                        "VSI_",
                                        "SHAPE_",
                                        "LIBKML_",
                                        "PG_",
                                        "GTIFF_",
                                        "GEOTIFF_",
                                        "TIFF_",
                                        "ESRI_",
                                        "PROJ_NETWORK",
                                        "PROJ_DEBUG",
                                        "SQLITE_",
                                        "AWS_",
                                        "KML_",
                                        "CENTER_LONG",
                                        "CHECK_WITH_INVERT_PROJ"};

void remove_options_from_environment() {
  std::vector<std::string> names;
  for (char** entry = environ; entry != nullptr && *entry != nullptr; ++entry) {
    const std::string_view variable = *entry;
    for (const std::string_view prefix : option_prefixes) {
      if (variable.starts_with(prefix)) names.emplace_back(variable.substr(0, variable.find('=')));
    }
  }
  for (const std::string& name : names) unsetenv(name.c_str());
}

CPLHTTPResult* refuse_to_fetch(const char*, CSLConstList, GDALProgressFunc, void*,
                               CPLHTTPFetchWriteFunc, void*, void*) {
  // A null result would hand the request on to the handler that does fetch.
  auto* result = static_cast<CPLHTTPResult*>(CPLCalloc(1, sizeof(CPLHTTPResult)));
  result->nStatus = 1;
  result->pszErrBuf = CPLStrdup("nothing is fetched over a network");
  return result;
}

void set_options() {
  // Cells of spreadsheets are read as their text, under the names in the first row.
  for (const char* sheet : {"XLSX", "ODS", "XLS"}) {
    CPLSetConfigOption(("OGR_" + std::string(sheet) + "_HEADERS").c_str(), "FORCE");
    CPLSetConfigOption(("OGR_" + std::string(sheet) + "_FIELD_TYPES").c_str(), "STRING");
  }
  CPLSetConfigOption("OGR_ARC_STEPSIZE", "0.1");  // degrees; a circle's area is then right to 5e-7
  CPLSetConfigOption("GDAL_CONFIG_FILE", "/dev/null");
  CPLSetConfigOption("GDAL_DISABLE_READDIR_ON_OPEN", "YES");
  CPLSetConfigOption("OGR_SQLITE_LIST_VIRTUAL_OGR", "NO");
  CPLSetConfigOption("LIBKML_RESOLVE_STYLE", "NO");
  CPLHTTPSetFetchCallback(refuse_to_fetch, nullptr);
  OSRSetPROJEnableNetwork(FALSE);
}

/// Drivers that ask other machines, or have other programs do their work.
constexpr std::array remote_drivers = {
    "AmigoCloud",   "Carto",    "Cloudant", "CouchDB", "CSW",      "DAAS",          "DODS",
    "EEDA",         "EEDAI",    "GFT",      "HANA",    "HTTP",     "Elasticsearch", "MongoDB",
    "MongoDBv3",    "MySQL",    "NGW",      "OAPIF",   "OCI",      "ODBC",          "OGCAPI",
    "MSSQLSpatial", "PLMOSAIC", "PLScenes", "PGeo",    "GPSBabel", "PostGISRaster", "TileDB",
    "WCS",          "WFS",      "WMS",      "WMTS"};

void register_promised_drivers() {
  RegisterOGRGeoJSON();
  RegisterOGRGeoPackage();
  RegisterOGRShape();
  RegisterOGRFlatGeobuf();
  RegisterOGRLIBKML();
  RegisterOGRKML();
  RegisterOGRXLSX();
  RegisterOGRODS();
  RegisterOGRXLS();
  RegisterOGRPG();
}

}  // namespace

void start_gdal() {
  static std::once_flag started;
  std::call_once(started, [] {
    remove_options_from_environment();
    set_options();
    register_promised_drivers();
  });
}

void register_local_drivers() {
  start_gdal();
  static std::once_flag registered;
  std::call_once(registered, [] {
    GDALDriverManager& drivers = *GetGDALDriverManager();
    std::vector<const char*> ours;  // of another part of the process no driver may be taken
    for (const char* name : remote_drivers) {
      if (drivers.GetDriverByName(name) == nullptr) ours.push_back(name);
    }
    GDALAllRegister();
    for (const char* name : ours) {
      const std::unique_ptr<GDALDriver> driver(drivers.GetDriverByName(name));
      if (driver != nullptr) drivers.DeregisterDriver(driver.get());
    }
  });
}

bool is_remote_driver(std::string_view name) {
  return std::find(remote_drivers.begin(), remote_drivers.end(), name) != remote_drivers.end();
}

std::vector<std::string> local_raster_drivers() {
  std::vector<std::string> names;
  GDALDriverManager& drivers = *GetGDALDriverManager();
  for (int i = 0; i < drivers.GetDriverCount(); ++i) {
    GDALDriver* const driver = drivers.GetDriver(i);
    if (driver == nullptr || driver->GetMetadataItem(GDAL_DCAP_RASTER) == nullptr) continue;
    if (!is_remote_driver(driver->GetDescription())) names.emplace_back(driver->GetDescription());
  }
  return names;
}

}  // namespace thiessen
