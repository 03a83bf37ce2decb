open Scc_exact
open Svg_number

type t = {
  fill : Css_colour.paint;
  fill_opacity : Rat.t;
  rule : Fill.rule;
  clip_rule : Fill.rule;
  colour : Css_colour.colour;
  stroke : Css_colour.paint;
  stroke_opacity : Rat.t;
  width : string;
  cap : Svg_stroke.cap;
  join : [ `Miter | `Round | `Bevel ];
  limit : Rat.t;
  dashes : string list;
  offset : string;
  stroke_first : bool;
  markers : bool * bool * bool;
  shown : bool;
  displayed : bool;
  own : own;
}

and own = { clip : string option; clipped : bool; fixed_width : bool; opacity : Rat.t; blended : bool }

type gradient = Between of Rat.t * Rat.t | Unseen | Ignored

let black = { Css_colour.rgb = 0; alpha = Rat.one }

let initial =
  {
    fill = Colour black;
    fill_opacity = Rat.one;
    rule = Nonzero;
    clip_rule = Nonzero;
    colour = black;
    stroke = Nothing;
    stroke_opacity = Rat.one;
    width = "1";
    cap = Butt;
    join = `Miter;
    limit = Rat.of_int 4;
    dashes = [];
    offset = "0";
    stroke_first = false;
    markers = (false, false, false);
    shown = true;
    displayed = true;
    own = { clip = None; clipped = true; fixed_width = false; opacity = Rat.one; blended = false };
  }

let bad format = Printf.ksprintf (fun m -> raise (Bad m)) format
let unread format = Printf.ksprintf (fun m -> raise (Unread m)) format

(* {1 Values} *)

let one_of name value choices =
  match List.assoc_opt value choices with Some choice -> choice | None -> bad "the %s %S" name value

let rule name value = one_of name value [ ("nonzero", Fill.Nonzero); ("evenodd", Fill.Even_odd) ]

(* Lengths are read where something is painted with them. *)
let length_of name value = if Svg_value.is_length value then value else bad "the %s %S" name value

(* Attributes have so many numbers in real drawings, that a longer list is a fault. *)
let max_dashes = 1_000

(* What has no negative lengths. *)
let size_of name value =
  let negative () = match Svg_number.with_unit value with q, _ -> Rat.sign q < 0 in
  if negative () then bad "a %s below 0" name else length_of name value

let dashes value =
  if value = "none" then []
  else begin
    let words = words value in
    if List.compare_length_with words max_dashes > 0 then
      unread "a stroke-dasharray of more than %d numbers" max_dashes;
    if List.compare_length_with words 0 = 0 then bad "the stroke-dasharray %S" value;
    List.map (size_of "stroke-dasharray") words
  end

let join value =
  match value with
  | "miter-clip" | "arcs" -> unread "the stroke-linejoin %S" value
  | _ -> one_of "stroke-linejoin" value [ ("miter", `Miter); ("round", `Round); ("bevel", `Bevel) ]

let limit value =
  match with_unit value with
  | q, "" -> if Rat.compare q Rat.one < 0 then bad "a stroke-miterlimit below 1" else q
  | _ -> bad "the stroke-miterlimit %S" value

let clip value =
  if value = "none" then None
  else match Css_colour.reference value with Some id -> Some id | None -> unread "the clip-path %S" value

(* {1 Properties} *)

(* The markers of one property, or of the shorthand, from [all]. *)
let marked style name all =
  let start, mid, stop = style.markers and start', mid', stop' = all in
  let markers =
    match name with
    | "marker-start" -> (start', mid, stop)
    | "marker-mid" -> (start, mid', stop)
    | "marker-end" -> (start, mid, stop')
    | _ -> all
  in
  { style with markers }

(* The value of an inherited property, by what has it. *)
let inherited name ~from style =
  match name with
  | "fill" -> Some { style with fill = from.fill }
  | "fill-opacity" -> Some { style with fill_opacity = from.fill_opacity }
  | "fill-rule" -> Some { style with rule = from.rule }
  | "clip-rule" -> Some { style with clip_rule = from.clip_rule }
  | "color" -> Some { style with colour = from.colour }
  | "stroke" -> Some { style with stroke = from.stroke }
  | "stroke-opacity" -> Some { style with stroke_opacity = from.stroke_opacity }
  | "stroke-width" -> Some { style with width = from.width }
  | "stroke-linecap" -> Some { style with cap = from.cap }
  | "stroke-linejoin" -> Some { style with join = from.join }
  | "stroke-miterlimit" -> Some { style with limit = from.limit }
  | "stroke-dasharray" -> Some { style with dashes = from.dashes }
  | "stroke-dashoffset" -> Some { style with offset = from.offset }
  | "paint-order" -> Some { style with stroke_first = from.stroke_first }
  | "marker" | "marker-start" | "marker-mid" | "marker-end" -> Some (marked style name from.markers)
  | "visibility" -> Some { style with shown = from.shown }
  | _ -> None

let colour style value =
  match Css_colour.paint value with
  | Colour colour -> { style with colour }
  | Current -> style
  | Nothing | Server _ -> bad "the color %S" value

let order style value =
  let words = List.filter (( <> ) "") (String.split_on_char ' ' value) in
  let once word = List.length (List.filter (String.equal word) words) <= 1 in
  let paint word = List.mem word [ "fill"; "stroke"; "markers" ] && once word in
  if words <> [ "normal" ] && (words = [] || not (List.for_all paint words)) then bad "the paint-order %S" value;
  let first = List.find_opt (fun w -> w = "fill" || w = "stroke") words in
  { style with stroke_first = first = Some "stroke" }

let displays =
  String.split_on_char ' '
    "inline block inline-block list-item flow flow-root run-in compact marker table inline-table table-caption \
     table-row-group table-header-group table-footer-group table-row table-column-group table-column table-cell \
     flex inline-flex grid inline-grid math ruby"

(* With a meaning of their own for an element of SVG, or for browsers alone. *)
let other_displays =
  String.split_on_char ' '
    "contents ruby-base ruby-text ruby-base-container ruby-text-container grid-lanes inline-grid-lanes masonry \
     inline-masonry"

let is_of_browser value =
  String.length value > 1 && value.[0] = '-' && (value.[1] = '-' || (value.[1] >= 'a' && value.[1] <= 'z'))

let display value =
  if List.mem value displays then true
  else if value = "none" then false
  else if List.mem value other_displays || is_of_browser value || String.contains value ' ' then
    unread "the display %S" value
  else bad "the display %S" value

let clipped value =
  if value = "overlay" || String.contains value ' ' then unread "the overflow %S" value;
  one_of "overflow" value
    [ ("visible", false); ("auto", false); ("hidden", true); ("scroll", true); ("clip", true) ]

let fixed_width value =
  let effects =
    [ "non-scaling-stroke"; "non-scaling-size"; "non-rotation"; "fixed-position"; "viewport"; "screen" ]
  in
  let words = List.filter (( <> ) "") (String.split_on_char ' ' value) in
  if not (value = "none" || List.for_all (fun w -> List.mem w effects) words) then
    bad "the vector-effect %S" value;
  value <> "none"

let stop_colour value =
  match Css_colour.paint value with
  | (Colour _ | Current) as paint -> paint
  | Nothing | Server _ -> bad "a stop-color that is no colour"

let modes =
  String.split_on_char ' '
    "multiply screen overlay darken lighten color-dodge color-burn hard-light soft-light difference exclusion hue \
     saturation color luminosity"

(* The modes of the list leave the opacity as it is; others do not. *)
let blended value =
  if List.mem value [ "plus-lighter"; "plus-darker" ] then unread "the mix-blend-mode %S" value;
  one_of "mix-blend-mode" value (("normal", false) :: List.map (fun mode -> (mode, true)) modes)

let given style name value =
  match name with
  | "fill" -> { style with fill = Css_colour.paint value }
  | "fill-opacity" -> { style with fill_opacity = share value }
  | "fill-rule" -> { style with rule = rule name value }
  | "clip-rule" -> { style with clip_rule = rule name value }
  | "color" -> colour style value
  | "stroke" -> { style with stroke = Css_colour.paint value }
  | "stroke-opacity" -> { style with stroke_opacity = share value }
  | "stroke-width" -> { style with width = size_of name value }
  | "stroke-linecap" ->
    { style with cap = one_of name value [ ("butt", Svg_stroke.Butt); ("round", Round_cap); ("square", Square) ] }
  | "stroke-linejoin" -> { style with join = join value }
  | "stroke-miterlimit" -> { style with limit = limit value }
  | "stroke-dasharray" -> { style with dashes = dashes value }
  | "stroke-dashoffset" -> { style with offset = length_of name value }
  | "paint-order" -> order style value
  | "marker" | "marker-start" | "marker-mid" | "marker-end" -> 
    let on = value <> "none" in
    if on && Css_colour.reference value = None then bad "the %s %S" name value;
    marked style name (on, on, on)
  | "visibility" -> 
    { style with shown = one_of name value [ ("visible", true); ("hidden", false); ("collapse", false) ] }
  | "display" -> { style with displayed = display value && style.displayed }
  | "opacity" -> { style with own = { style.own with opacity = share value } }
  | "clip-path" -> { style with own = { style.own with clip = clip value } }
  | "overflow" -> { style with own = { style.own with clipped = clipped value } }
  | "mix-blend-mode" -> { style with own = { style.own with blended = blended value } }
  | "vector-effect" -> { style with own = { style.own with fixed_width = fixed_width value } }
  | "stop-color" -> ignore (stop_colour value); style
  | "stop-opacity" -> ignore (share value); style
  | ("mask" | "filter") when value <> "none" -> unread "%s" name
  | _ -> style

let own_properties =
  [ "display"; "opacity"; "clip-path"; "overflow"; "vector-effect"; "mask"; "filter"; "mix-blend-mode" ]

let property ~around style (name, value) =
  let value = String.map (fun c -> if is_blank c then ' ' else c) value in
  match String.lowercase_ascii value with
  | ("inherit" | "unset" | "initial") as word when not (List.mem name own_properties) ->
    Option.value ~default:style
      (inherited name ~from:(if word = "initial" then initial else around) style)
  | "initial" | "unset" -> style
  | "inherit" | "revert" | "revert-layer" -> unread "the value %S of %s" value name
  | _ -> (
      try given style name value with Bad fault -> bad "%s, as the value of %s" fault name)

(* A value with functions is looked at if it is one of these alone, with plain values: others may have a meaning,
   such as calc(), var(), and colours made from others. So have words of browsers. *)
let is_looked_at value =
  let functions = [ "rgb"; "rgba"; "hsl"; "hsla"; "hwb"; "lab"; "lch"; "oklab"; "oklch"; "color" ] in
  match String.split_on_char '(' value with
  | [ _ ] -> not (is_of_browser value)
  | [ name; _ ] -> List.mem name functions
  | _ -> false

let is_valid name value =
  let value = String.lowercase_ascii value in
  let word = String.for_all (fun c -> (c >= 'a' && c <= 'z') || c = '-' || c = '_') value in
  let of_colour = List.mem name [ "fill"; "stroke"; "color"; "stop-color" ] in
  (* Browsers take such a limit, and SVG does not. *)
  let is_small_limit () =
    name = "stroke-miterlimit" && (match with_unit value with q, "" -> Rat.sign q >= 0 | _ -> false)
  in
  match name with
  | "transform" | "transform-origin" | "transform-box" -> Svg_transform.is_valid name value
  | _ -> (
      (not (is_looked_at value))
      ||
      match property ~around:initial initial (name, value) with
      | _ -> true
      | exception Bad _ -> is_small_limit ()
      | exception Unread _ -> not (word && of_colour && Css_colour.is_unknown value)
      | exception Beyond _ -> true)

(* Of each property the last value. *)
let last properties =
  let table = Hashtbl.create 16 in
  List.iteri (fun i (name, _) -> Hashtbl.replace table (name : string) i) properties;
  List.filteri (fun i (name, _) -> Hashtbl.find table name = i) properties

let of_properties around properties =
  List.fold_left (property ~around) { around with own = initial.own } (last properties)

(* {1 Painting} *)

let painted style paint opacity ~gradient =
  let source ?upper rgb alpha =
    Svg_layer.source ?upper:(Option.map (Rat.mul opacity) upper) ~rgb (Rat.mul opacity alpha)
  in
  let rec of_paint = function
    | Css_colour.Nothing -> None
    | Current -> of_paint (Colour style.colour)
    | Colour { rgb; alpha } -> source rgb alpha
    | Server (id, instead) -> (
        match (gradient id, instead) with
        | Some (Between (low, high)), _ -> source ~upper:high 0 low
        | Some Unseen, _ | Some Ignored, None -> None
        | (Some Ignored | None), Some instead -> of_paint instead
        | None, None -> bad "the reference \"#%s\" to no gradient" id)
  in
  of_paint paint

let stroke style ~length =
  let width = length style.width in
  if Rat.sign width = 0 then None
  else begin
    let lengths = List.map length style.dashes in
    let solid = List.for_all (fun q -> Rat.sign q = 0) lengths in
    let doubled = if List.length lengths land 1 = 1 then lengths @ lengths else lengths in
    if style.own.fixed_width then unread "the vector-effect of strokes";
    Some
      {
        Svg_stroke.half = Rat.mul Rat.half width;
        cap = style.cap;
        join = (match style.join with `Miter -> Miter style.limit | `Round -> Round | `Bevel -> Bevel);
        dashes = (if solid then [] else doubled);
        offset = length style.offset;
      }
  end
