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
  markers : bool;
  shown : bool;
  displayed : bool;
  own : own;
}

and own = { clip : string option; clipped : bool; fixed_width : bool; opacity : Rat.t }

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
    markers = false;
    shown = true;
    displayed = true;
    own = { clip = None; clipped = true; fixed_width = false; opacity = Rat.one };
  }

let bad format = Printf.ksprintf (fun m -> raise (Bad m)) format
let unread format = Printf.ksprintf (fun m -> raise (Unread m)) format

(* {1 Values} *)

(* A share, as a number or in percent. *)
let share text =
  let c = { text; at = 0 } in
  let q = number c in
  let q = if String.contains text '%' then Rat.div q (Rat.of_int 100) else q in
  Rat.max Rat.zero (Rat.min Rat.one q)

let plain name text =
  match all text with [ q ] -> q | _ -> bad "the %s %S" name text

let one_of name value choices =
  match List.assoc_opt value choices with Some choice -> choice | None -> bad "the %s %S" name value

let rule name value = one_of name value [ ("nonzero", Fill.Nonzero); ("evenodd", Fill.Even_odd) ]

(* Attributes have so many numbers in real drawings, that a longer list is a fault. *)
let max_dashes = 1_000

let dashes value =
  if value = "none" then []
  else begin
    let blank c = if is_blank c || c = ',' then ' ' else c in
    let words = List.filter (( <> ) "") (String.split_on_char ' ' (String.map blank value)) in
    if List.compare_length_with words max_dashes > 0 then bad "a stroke-dasharray of more than %d numbers"
        max_dashes;
    words
  end

let join value =
  match value with
  | "miter-clip" | "arcs" -> unread "the stroke-linejoin %S" value
  | _ -> one_of "stroke-linejoin" value [ ("miter", `Miter); ("round", `Round); ("bevel", `Bevel) ]

let limit value =
  let q = plain "stroke-miterlimit" value in
  if Rat.compare q Rat.one < 0 then bad "a stroke-miterlimit below 1";
  q

let clip value =
  if value = "none" then None
  else match Css_colour.reference value with Some id -> Some id | None -> unread "the clip-path %S" value

(* {1 Properties} *)

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
  | "marker" | "marker-start" | "marker-mid" | "marker-end" -> Some { style with markers = from.markers }
  | "visibility" -> Some { style with shown = from.shown }
  | _ -> None

let colour style value =
  match Css_colour.paint value with
  | Colour colour -> { style with colour }
  | Nothing -> { style with colour = { black with alpha = Rat.zero } }
  | Current -> style
  | Server _ -> bad "the color %S" value

let order style value =
  let words = String.split_on_char ' ' value in
  let first = List.find_opt (fun w -> w = "fill" || w = "stroke") words in
  { style with stroke_first = first = Some "stroke" }

let given style name value =
  match name with
  | "fill" -> { style with fill = Css_colour.paint value }
  | "fill-opacity" -> { style with fill_opacity = share value }
  | "fill-rule" -> { style with rule = rule name value }
  | "clip-rule" -> { style with clip_rule = rule name value }
  | "color" -> colour style value
  | "stroke" -> { style with stroke = Css_colour.paint value }
  | "stroke-opacity" -> { style with stroke_opacity = share value }
  | "stroke-width" -> { style with width = value }
  | "stroke-linecap" ->
    { style with cap = one_of name value [ ("butt", Svg_stroke.Butt); ("round", Round_cap); ("square", Square) ] }
  | "stroke-linejoin" -> { style with join = join value }
  | "stroke-miterlimit" -> { style with limit = limit value }
  | "stroke-dasharray" -> { style with dashes = dashes value }
  | "stroke-dashoffset" -> { style with offset = value }
  | "paint-order" -> order style value
  | "marker" | "marker-start" | "marker-mid" | "marker-end" -> { style with markers = value <> "none" }
  | "visibility" -> { style with shown = value = "visible" }
  | "display" -> { style with displayed = style.displayed && value <> "none" }
  | "opacity" -> { style with own = { style.own with opacity = share value } }
  | "clip-path" -> { style with own = { style.own with clip = clip value } }
  | "overflow" -> { style with own = { style.own with clipped = value <> "visible" && value <> "auto" } }
  | "vector-effect" -> { style with own = { style.own with fixed_width = value <> "none" } }
  | ("mask" | "filter") when value <> "none" -> unread "%s" name
  | _ -> style

let own_properties =
  [ "display"; "opacity"; "clip-path"; "overflow"; "vector-effect"; "mask"; "filter" ]

let property ~around style (name, value) =
  match String.lowercase_ascii value with
  | ("inherit" | "unset" | "initial") as word when not (List.mem name own_properties) ->
    Option.value ~default:style
      (inherited name ~from:(if word = "initial" then initial else around) style)
  | "initial" | "unset" -> style
  | "inherit" | "revert" | "revert-layer" -> unread "the value %S of %s" value name
  | _ -> given style name value

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
        | Some (Some (low, high)), _ -> source ~upper:high 0 low
        | Some None, _ -> None
        | None, Some instead -> of_paint instead
        | None, None -> bad "the reference \"#%s\" to no gradient" id)
  in
  of_paint paint

let stroke style ~length =
  let width = length style.width in
  if Rat.sign width < 0 then bad "a stroke-width below 0";
  if Rat.sign width = 0 then None
  else begin
    let lengths = List.map length style.dashes in
    if List.exists (fun q -> Rat.sign q < 0) lengths then bad "a stroke-dasharray with a length below 0";
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
