#include "pages/chart_engine.hpp"

#include <fmt/format.h>
#include <js/CharacterEncoding.h>
#include <js/CompilationAndEvaluation.h>
#include <js/Exception.h>
#include <js/Initialization.h>
#include <js/SourceText.h>
#include <jsapi.h>
#include <jsfriendapi.h>

#include <set>
#include <stdexcept>

#include "pages/asset_table.hpp"

namespace reeve {
namespace {

constexpr unsigned heap_bytes = 1U << 30U;
constexpr int static_width = 640;

struct Library {
  Library() {
    if (!JS_Init()) throw std::runtime_error("the chart engine does not start");
  }
  ~Library() { JS_ShutDown(); }
};

const JSClass global_class = {
    "global", JSCLASS_GLOBAL_FLAGS, &JS::DefaultGlobalClassOps, nullptr, nullptr, nullptr};

// What Vega expects of a browser, as far as drawing to text needs it.
constexpr std::string_view surroundings =
    "globalThis.structuredClone = value => JSON.parse(JSON.stringify(value));"
    "globalThis.console = {log() {}, info() {}, debug() {}, warn() {}, error() {}};";

constexpr std::string_view drawing =
    "globalThis.drawn = {svg: '', error: 'nothing was drawn'};"
    "globalThis.draw = (text, ids) => {"
    "  drawn = {svg: '', error: 'nothing was drawn'};"
    "  vega.resetSVGDefIds();"
    "  const view = new vega.View(vega.parse(vegaLite.compile(JSON.parse(text)).spec),"
    "                             {renderer: 'none'});"
    "  const named = svg => svg.replace(/(id=\"|url\\(#)(clip|gradient)/g, `$1${ids}-$2`);"
    "  view.toSVG().then(svg => { drawn = {svg: named(svg), error: ''}; view.finalize(); },"
    "                    error => { drawn = {svg: '', error: String(error)}; });"
    "};";

class Interpreter {
 public:
  Interpreter() {
    static const Library library;
    context_ = JS_NewContext(heap_bytes);
    if (context_ == nullptr || !js::UseInternalJobQueues(context_) ||
        !JS::InitSelfHostedCode(context_)) {
      throw std::runtime_error("the chart engine does not start");
    }
    global_.init(context_, JS_NewGlobalObject(context_, &global_class, nullptr,
                                              JS::FireOnNewGlobalHook, JS::RealmOptions()));
    run(surroundings, "surroundings");
    run(asset("vega.js"), "vega.js");
    run(asset("vega-lite.js"), "vega-lite.js");
    run(drawing, "drawing");
  }

  ~Interpreter() {
    global_.reset();
    JS_DestroyContext(context_);
  }

  Interpreter(const Interpreter&) = delete;
  Interpreter& operator=(const Interpreter&) = delete;

  // Once; what it declares stays.
  void load(std::string_view script) {
    if (loaded_.contains(std::string(script))) return;
    run(asset(script), std::string(script).c_str());
    loaded_.emplace(script);
  }

  // The value as text.
  std::string run(std::string_view code, const char* name) {
    const JSAutoRealm realm(context_, global_);
    JS::CompileOptions options(context_);
    options.setFileAndLine(name, 1);
    JS::SourceText<mozilla::Utf8Unit> source;
    JS::RootedValue value(context_);
    if (!source.init(context_, code.data(), code.size(), JS::SourceOwnership::Borrowed) ||
        !JS::Evaluate(context_, options, source, &value)) {
      throw std::runtime_error(fmt::format("chart engine: {}: {}", name, exception()));
    }
    js::RunJobs(context_);
    if (!value.isString()) return "";
    const JS::RootedString text(context_, value.toString());
    const JS::UniqueChars characters = JS_EncodeStringToUTF8(context_, text);
    return characters ? characters.get() : "";
  }

 private:
  std::string exception() {
    JS::ExceptionStack stack(context_);
    JS::ErrorReportBuilder report(context_);
    if (!JS::StealPendingExceptionStack(context_, &stack) ||
        !report.init(context_, stack, JS::ErrorReportBuilder::NoSideEffects)) {
      return "unknown error";
    }
    return report.toStringResult().c_str();
  }

  std::set<std::string> loaded_;
  JSContext* context_ = nullptr;
  JS::PersistentRootedObject global_;
};

// SpiderMonkey takes one context for each thread, and starting one costs more than a chart.
Interpreter& interpreter() {
  static Interpreter interpreter;
  return interpreter;
}

// As a JSON text in a JSON string: no character of it can end the JavaScript string.
std::string literal(const Json& json) {
  return Json(json.dump(-1, ' ', true, Json::error_handler_t::replace)).dump();
}

}  // namespace

std::string chart_svg(const Json& specification, const std::string& ids) {
  Json whole = specification;
  if (whole.value("width", Json()) == "container") whole["width"] = static_width;
  whole["config"] = Json::parse(asset("chart_theme.json"))["light"];
  whole["background"] = "white";
  interpreter().run("draw(" + literal(whole) + ", " + Json(ids).dump() + ")", "specification");
  const std::string error = interpreter().run("drawn.error", "result");
  if (!error.empty()) throw std::runtime_error("chart engine: " + error);
  return interpreter().run("drawn.svg", "result") + "\n";
}

Json script_value(std::string_view script, const std::string& function, const Json& argument) {
  interpreter().load(script);
  return Json::parse(interpreter().run(
      "JSON.stringify(" + function + "(JSON.parse(" + literal(argument) + ")))", "script"));
}

}  // namespace reeve
