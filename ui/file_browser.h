// The built-in file browser: a dialog that finds a file to open or a place to save to, where the system has none.
#pragma once

#include "ui/folder_listing.h"
#include "ui/frame_context.h"

namespace fieldwright::ui {

class FileBrowser {
public:
    // Starts in `folder`, or the nearest one that exists; `name` is suggested for a file to be written.
    void open(ChooseFile what, const std::string& folder, std::string name);
    bool is_open() const { return open_; }
    // `shown`: nothing else is asked at the moment. Asks for the file by a request when it is chosen.
    void draw(FrameContext& frame, bool shown);

private:
    bool saving() const { return what_.then != ChooseFile::Then::open && what_.then != ChooseFile::Then::picture; }
    void go_to(const std::filesystem::path& folder);
    void refresh();
    void go_up();
    void draw_path_row(FrameContext& frame);
    void draw_new_folder(FrameContext& frame);
    void draw_entries(FrameContext& frame);
    void draw_entry(FrameContext& frame, std::size_t index);
    void draw_name(FrameContext& frame);
    void draw_buttons(FrameContext& frame);
    void use_keys();
    void pick(std::size_t index);                        // a file: its name is taken
    void enter(std::size_t index, FrameContext& frame);  // a folder: shown; a file: chosen
    void type_path();
    void accept(FrameContext& frame);
    std::filesystem::path chosen_path() const;
    std::string refusal_of(const std::filesystem::path& path) const;  // why it cannot be chosen; empty when it can

    ChooseFile what_{ChooseFile::Then::open, {}};
    bool open_ = false, appearing_ = false, all_files_ = false;
    std::filesystem::path folder_;
    FolderListing listing_;
    std::string path_text_, name_, error_;
    std::string new_folder_;
    bool naming_folder_ = false, naming_begins_ = false;
    int highlighted_ = -1;
    bool scroll_ = false;
    std::string replace_;  // the file that the user was asked about; accepting it again replaces it
};

}  // namespace fieldwright::ui
