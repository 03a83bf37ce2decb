type t = Read | Still | Unread of string
type element = Group | Shape | Use | Viewport | Silent | Refused of string

let words text = List.filter (fun w -> w <> "") (String.split_on_char ' ' text)
let begins prefix text =
  let n = String.length prefix in
  String.length text >= n && String.equal (String.sub text 0 n) prefix

(* {1 Elements} *)

let groups = words "g a switch"
let shapes = words "path rect circle ellipse polygon polyline line"

(* What they hold is painted where something refers to it, if that is read. *)
let silent =
  words
    "style title desc metadata defs clipPath mask linearGradient radialGradient filter symbol marker \
     pattern script view cursor color-profile font font-face glyph missing-glyph hkern \
     vkern meshgradient hatch solidcolor"

let cures =
  [
    ("image", "only outlines are read; for pixels give the picture itself, as PNG");
  ]

let animations = words "animate animateColor animateMotion animateTransform set discard"

let element name =
  if List.mem name groups then Group
  else if List.mem name shapes then Shape
  else if name = "use" then Use
  else if name = "svg" then Viewport
  else if List.mem name silent then Silent
  else if List.mem name animations then Refused "remove what moves: one picture is read"
  else if List.mem name (words "text tspan tref textPath altGlyph") then
    Refused "turn the text into paths (in Inkscape: Path, Object to Path)"
  else Refused (Option.value (List.assoc_opt name cures) ~default:"turn it into paths, or remove it")

let within_shape name = List.mem name (words "title desc metadata script")

(* {1 Properties} *)

let read =
  words
    "fill fill-rule fill-opacity color opacity visibility display stroke stroke-width stroke-opacity \
     stroke-linecap stroke-linejoin stroke-miterlimit stroke-dasharray stroke-dashoffset paint-order \
     vector-effect marker marker-start marker-mid marker-end clip-path clip-rule overflow mask filter transform \
     transform-origin transform-box stop-color stop-opacity mix-blend-mode"

(* Of texts, gradients and filters, and of how well something is painted. *)
let still =
  words
    "shape-rendering image-rendering text-rendering color-rendering color-interpolation \
     color-interpolation-filters color-profile pointer-events cursor enable-background isolation \
     lighting-color letter-spacing word-spacing writing-mode direction unicode-bidi dominant-baseline \
     alignment-baseline baseline-shift baseline-source kerning glyph-orientation-horizontal \
     glyph-orientation-vertical line-height white-space inline-size shape-inside shape-subtract shape-margin \
     shape-padding shape-image-threshold tab-size hyphens line-break word-break overflow-wrap word-wrap quotes \
     user-select touch-action will-change solid-color solid-opacity mask-type image-orientation \
     line-increment audio-level viewport-fill viewport-fill-opacity buffered-rendering"

let still_prefixes = [ "-"; "font"; "text-"; "stop-"; "flood-" ]

(* These have one value that changes nothing. *)
let harmless =
  [
    ("clip", "auto"); ("translate", "none"); ("rotate", "none");
    ("scale", "none"); ("offset-path", "none"); ("zoom", "1");
    ("animation", "none"); ("animation-name", "none"); ("content-visibility", "visible");
  ]

let property name =
  if List.mem name read || List.mem_assoc name harmless then Read
  else if List.mem name still || List.exists (fun p -> begins p name) still_prefixes then Still
  else if List.mem name (words "x y cx cy r rx ry width height d points") then
    Unread "write it as an attribute of the element"
  else Unread "remove it if it changes nothing of what is seen"

(* {1 Attributes} *)

let geometry =
  [
    ("path", "d"); ("rect", "x y width height rx ry"); ("circle", "cx cy r"); ("ellipse", "cx cy rx ry");
    ("polygon", "points"); ("polyline", "points"); ("line", "x1 y1 x2 y2");
    ("svg", "x y viewBox width height preserveAspectRatio");
    ("symbol", "x y viewBox width height preserveAspectRatio"); ("use", "x y width height href xlink:href");
    ("clipPath", "clipPathUnits");
  ]

let unused =
  [
    ("a", "href target rel download hreflang ping referrerpolicy type");
    ("svg", "version baseProfile zoomAndPan contentScriptType contentStyleType timelineBegin playbackorder \
             snapshotTime xmlns");
    ("stop", "offset");
    ("linearGradient", "x1 y1 x2 y2 gradientUnits gradientTransform spreadMethod href xlink:href");
    ("radialGradient", "cx cy r fx fy fr gradientUnits gradientTransform spreadMethod href xlink:href");
  ]

let of_all =
  words
    "id class lang tabindex role autofocus pathLength externalResourcesRequired nonce slot part \
     about content datatype property rel resource rev typeof focusable focusHighlight t p-id"
let prefixes = [ "nav-"; "data-"; "aria-"; "on"; "xmlns"; "xml:"; "xlink:" ]

let conditions =
  words "requiredFeatures requiredExtensions systemLanguage requiredFonts requiredFormats"

let is_condition name = List.mem name conditions

let attribute element name =
  let has table = List.mem name (words (Option.value (List.assoc_opt element table) ~default:"")) in
  if has geometry || String.equal name "style" then Read
  else if has unused || List.mem name of_all || List.exists (fun p -> begins p name) prefixes then Still
  else if List.mem name conditions then
    Unread "what it shows depends on the reader: remove the attribute, or the element"
  else property name
