# Inter (text), JetBrains Mono (code and columns of numbers) and Font Awesome 4.7 (icons), built into the program.
function(fieldwright_font variable file)
    find_file(${variable} ${file} PATHS /usr/share/fonts PATH_SUFFIXES opentype/inter truetype/jetbrains-mono
              truetype/font-awesome opentype/font-awesome REQUIRED)
endfunction()
fieldwright_font(FONT_INTER_REGULAR Inter-Regular.otf)
fieldwright_font(FONT_INTER_SEMIBOLD Inter-SemiBold.otf)
fieldwright_font(FONT_MONO JetBrainsMono-Regular.ttf)
fieldwright_font(FONT_ICONS fontawesome-webfont.ttf)
