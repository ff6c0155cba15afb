#include "game/ui/ui.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <backends/imgui_impl_opengl3.h>
#include <epoxy/gl.h>
#include <imgui.h>

#include "game/ui/feed.h"
#include "game/ui/panels.h"
#include "game/ui/style.h"

namespace game::ui {
namespace {

constexpr double kLetterHeight = 16;  // px at scale 1, which is 96 dpi
constexpr double kLeastLetters = 10;  // px, in a window without room

// px, at a text size of 100 %. A monitor that calls itself coarser than 96 dpi gets no smaller letters.
double usual_height(const ScreenSize& size) {
    return kLetterHeight * std::max(size.scale, 1.0);
}

// px, as the user has set it; smaller on a screen that else had no room for the bars, as long as it can be read.
double letter_height(const ScreenSize& size, double letters) {
    const double wanted = std::clamp(usual_height(size) * letters, 0.5 * kLetterHeight, 8 * kLetterHeight);
    const double fits = std::min(size.width / kLeastWidth, size.height / kLeastHeight);
    return std::round(std::min(wanted, std::max(fits, kLeastLetters)));
}

// ImGui's context, current during its lifetime.
struct Context {
    Context() {
        IMGUI_CHECKVERSION();
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.LogFilename = nullptr;
        io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
        io.MousePos = {-1e6f, -1e6f};
    }
    ~Context() { ImGui::DestroyContext(); }
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
};

}  // namespace

struct Ui::Parts {
    Context context;
    Feed feed;
    Desk desk;
    std::optional<std::filesystem::path> font;
    Screen* screen = nullptr;  // lent for a frame
    std::string clipboard;     // last text given to ImGui
    bool gl_ready = false, letters_stale = false;

    ~Parts() {
        if (gl_ready) ImGui_ImplOpenGL3_Shutdown();
    }
    void lend_clipboard();
    void draw_letters_texture();
};

void Ui::Parts::lend_clipboard() {
    ImGuiIO& io = ImGui::GetIO();
    io.ClipboardUserData = this;
    io.SetClipboardTextFn = [](void* parts, const char* text) {
        if (Screen* const to = static_cast<Parts*>(parts)->screen) to->set_clipboard(text);
    };
    io.GetClipboardTextFn = [](void* user) {
        auto* const parts = static_cast<Parts*>(user);
        parts->clipboard = parts->screen ? parts->screen->clipboard() : std::string();
        if (!parts->desk.widgets.types_name())
            std::ranges::replace(parts->clipboard, ',', '.');  // as in Feed
        return parts->clipboard.c_str();
    };
}

// The frame was built with the old texture's name, so replace it.
void Ui::Parts::draw_letters_texture() {
    void* const before = ImGui::GetIO().Fonts->TexID;
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
    void* const texture = ImGui::GetIO().Fonts->TexID;
    const ImDrawData& drawing = *ImGui::GetDrawData();
    for (int i = 0; i < drawing.CmdListsCount; ++i)
        for (ImDrawCmd& command : drawing.CmdLists[i]->CmdBuffer)
            if (command.TextureId == before) command.TextureId = texture;
    letters_stale = false;
}

Ui::Ui(std::optional<std::filesystem::path> font) : parts_(std::make_unique<Parts>()) {
    parts_->font = std::move(font);
    parts_->desk.widgets.em = 0;  // no letters yet
    parts_->lend_clipboard();
}

Ui::~Ui() = default;

bool Ui::hides_panels() const {
    return parts_->desk.panels.hidden();
}

double Ui::free_height(const ScreenSize& size, double letters) const {
    constexpr double kBars = 11.9;  // em, before they were drawn
    const double height = size.height;
    if (hides_panels()) return height;
    const Desk& desk = parts_->desk;
    const bool drawn = desk.time_bar_top > 0;
    const double bars =
        drawn ? height - (desk.time_bar_top - desk.toolbar_bottom) : kBars * letter_height(size, letters);
    return std::max(height - bars, height / 2);
}

void Ui::begin(std::span<const Event> events, Screen& screen, double letters, double elapsed_s) {
    Parts& parts = *parts_;
    Desk& desk = parts.desk;
    const ScreenSize size = screen.size();
    parts.screen = &screen;

    // A minimised frame is begun but never built. Ended here, because letters may change only between frames.
    if (ImGui::GetFrameCount() > 0) ImGui::EndFrame();
    const bool minimised = size.width == 0 && desk.widgets.em > 0;
    const float em = minimised ? desk.widgets.em : static_cast<float>(letter_height(size, letters));
    if (em != desk.widgets.em) {
        desk.widgets.em = em;
        desk.widgets.letters = set_letters(parts.font, em);
        parts.letters_stale = true;
    }
    desk.usual_em = usual_height(size);
    ImGuiIO& io = ImGui::GetIO();
    desk.size = io.DisplaySize = {static_cast<float>(size.width), static_cast<float>(size.height)};
    io.DeltaTime = static_cast<float>(std::clamp(elapsed_s, 1e-4, 1.0));
    if (desk.menu.open && desk.menu.page == Menu::Page::kKeys)
        desk.key_choice.hear(events);
    else
        desk.key_choice = {};
    parts.feed.type_names(parts.desk.widgets.types_name());
    parts.feed.add(events);
    ImGui::NewFrame();
}

bool Ui::keeps_mouse() const {
    return ImGui::GetIO().WantCaptureMouse;
}

KeysKept Ui::keeps_keys() const {
    const Desk& desk = parts_->desk;
    if (desk.menu.open && desk.key_choice.asked) return KeysKept::kAll;
    if (ImGui::GetIO().WantTextInput) return KeysKept::kOfText;
    return desk.menu.open ? KeysKept::kOfWorld : KeysKept::kNone;
}

void Ui::begin_menu() {
    parts_->desk.menu.show();
    parts_->desk.menu.begins = true;
}

void Ui::close_menu() {
    parts_->desk.menu.close();
}

bool Ui::shows_menu() const {
    return parts_->desk.menu.open;
}

bool Ui::shows_measures() const {
    const Desk& desk = parts_->desk;
    return desk.panels.is_open(Panel::kMeasure) && !desk.panels.hidden() && !desk.menu.open;
}

bool Ui::perform(Verb verb) {
    OpenPanels& panels = parts_->desk.panels;
    if (verb == Verb::kTogglePanels) {
        panels.toggle_all();
        return true;
    }
    Menu& menu = parts_->desk.menu;
    if (verb == Verb::kClosePanel) {
        if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup))
            parts_->desk.widgets.close_choice();
        else if (menu.open)
            menu.back();
        else if (panels.any_open())
            panels.close_one();
        else
            menu.show();
        return true;
    }
    if (verb == Verb::kMenu) {
        menu.open ? menu.close() : menu.show();
        return true;
    }
    const auto info = std::find_if(std::begin(kPanelInfos), std::end(kPanelInfos),
                                   [verb](const PanelInfo& each) { return each.verb == verb; });
    if (info == std::end(kPanelInfos)) return false;
    if (menu.open) menu.close();
    panels.toggle(info->panel);
    return true;
}

void Ui::build(const Facts& facts, Actions& actions) {
    Desk& desk = parts_->desk;
    set_contrast(facts.display.contrast);
    desk.widgets.begin_frame(static_cast<double>(ImGui::GetIO().DeltaTime));
    if (facts.opening_s) {
        opening(desk, facts);
    } else if (desk.menu.open) {
        menu(desk, facts, actions);
    } else if (facts.photo) {
        photo_bar(desk, facts, actions);
    } else if (!desk.panels.hidden()) {
        toolbar(desk, facts, actions);
        time_bar(desk, facts, actions);
        hint(desk, facts);
        bare_ground(desk, facts, actions);
        guide(desk, facts, actions);
        dam(desk, facts);
        challenge(desk, facts, actions);
        run_ends(desk, facts);
        section_line(desk, facts);
        stroke_note(desk, facts);
        readings(desk, facts);
        open_panels(desk, facts, actions);
        result_card(desk, facts, actions);
        lesson_card(desk, facts, actions);
    }
    pad_wheel(desk, facts);
    notices(desk, facts, facts.opening_s || (desk.panels.hidden() && !facts.photo));
    if (!facts.opening_s && !facts.photo && !desk.menu.open) slide_labels(desk, facts);
    ImGui::GetIO().MouseDrawCursor = facts.gamepad && facts.gamepad->in_use();
    ImGui::Render();
}

void Ui::build_title() {
    Desk& desk = parts_->desk;
    // Dusk, from the sky to the snow below it.
    constexpr ImU32 kSky = IM_COL32(38, 62, 96, 255), kSnow = IM_COL32(132, 156, 186, 255);
    ImGui::GetBackgroundDrawList()->AddRectFilledMultiColor({0, 0}, desk.size, kSky, kSky, kSnow, kSnow);
    title(desk, 1);
    ImGui::Render();
}

void Ui::draw() {
    Parts& parts = *parts_;
    const bool srgb = glIsEnabled(GL_FRAMEBUFFER_SRGB);
    glDisable(GL_FRAMEBUFFER_SRGB);  // our colours are sRGB already
    if (!parts.gl_ready) {
        ImGui_ImplOpenGL3_Init("#version 450");
        ImGui_ImplOpenGL3_CreateDeviceObjects();
        parts.gl_ready = true;
        parts.letters_stale = true;
    }
    parts.desk.card_map.upload_if_new();
    if (parts.letters_stale) parts.draw_letters_texture();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    // Afterwards, because the frame was built with the textures before.
    parts.desk.pictures.upload_if_read();
    parts.desk.shelf_pictures.upload_if_read();
    if (srgb) glEnable(GL_FRAMEBUFFER_SRGB);
}

std::optional<Ui::Place> Ui::find(std::string_view label) const {
    const Places::Place* const place = parts_->desk.widgets.places().find(label);
    if (!place) return {};
    return Place{static_cast<double>(place->from.x), static_cast<double>(place->from.y),
                 static_cast<double>(place->to.x - place->from.x),
                 static_cast<double>(place->to.y - place->from.y)};
}

std::vector<std::string> Ui::cut() const {
    std::vector<std::string> words;
    for (const Places::CutWords& each : parts_->desk.widgets.places().cut()) words.emplace_back(each.data());
    return words;
}

}  // namespace game::ui
