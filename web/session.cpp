#include <taut/web/session.h>

#include <exception>
#include <functional>
#include <map>
#include <new>
#include <optional>
#include <utility>

#include <taut/web/detail/answers.h>

namespace taut::web {

struct Session::Impl {
  std::optional<Ground> ground;

  Ground& kept() {
    if (!ground) throw InputError("", 0, "no world was loaded");
    return *ground;
  }

  Json keep(World world, ReadNotes notes) {
    Ground made(std::move(world), std::move(notes));
    Json answer = world_answer(made);  // whatever is wrong is thrown before the old one goes
    ground.emplace(std::move(made));
    return answer;
  }

  Json load(const Request& request) {
    ReadNotes notes;
    World world = loaded_world(request, notes);
    return keep(std::move(world), std::move(notes));
  }

  Json edit(const Request& request) {
    ReadNotes notes = kept().notes();
    return keep(edited_world(kept().world(), request), std::move(notes));
  }

  Json answer(const Request& request) {
    using Work = Json (*)(Impl&, const Request&);
    static const std::map<std::string, Work, std::less<>> kWork{
        {"load", [](Impl& impl, const Request& asked) { return impl.load(asked); }},
        {"edit", [](Impl& impl, const Request& asked) { return impl.edit(asked); }},
        {"world", [](Impl& impl, const Request&) { return world_answer(impl.kept()); }},
        {"path", [](Impl& impl, const Request& asked) { return path_answer(impl.kept(), asked); }},
        {"widest", [](Impl& impl, const Request& asked) { return widest_answer(impl.kept(), asked); }},
        {"layer", [](Impl& impl, const Request& asked) { return layer_answer(impl.kept(), asked); }},
        {"save", [](Impl& impl, const Request& asked) { return save_answer(impl.kept(), asked); }},
        {"formats", [](Impl& impl, const Request&) { return formats_answer(impl.kept()); }},
        {"self-test", [](Impl&, const Request&) { return self_test_answer(); }}};
    const std::string what = request.text("do").value_or("");
    const auto work = kWork.find(what);
    if (work == kWork.end()) throw InputError("", 0, "there is no request '" + what + "'");
    return work->second(*this, request);
  }
};

namespace {

std::string error(const char* what) { return json_line(Json{{"error", what}}); }

}  // namespace

Session::Session() : impl_(std::make_unique<Impl>()) {}
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;
Session::~Session() = default;

std::string Session::answer(std::string_view request) noexcept {
  try {
    return json_line(impl_->answer(Request(request)));
  } catch (const std::bad_alloc&) {
    return R"({"error":"out of memory"})";
  } catch (const std::exception& thrown) {
    return error(thrown.what());
  } catch (...) {
    return R"({"error":"internal error"})";
  }
}

}  // namespace taut::web
