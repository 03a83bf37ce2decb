open Scc_base
open Scc_exact
open Svg_number

let space = "http://www.w3.org/2000/svg"

(* An XML file, with white space before it or not. *)
let is text =
  let blank c = List.mem c [ ' '; '\t'; '\n'; '\r' ] in
  let rec first i = if i < String.length text && blank text.[i] then first (i + 1) else i in
  let i = first (Source.after_mark text) in
  i < String.length text && text.[i] = '<'

let max_corners = 1_000_000
let max_depth = 200

exception Refused of Diag.t

(* {1 Elements} *)

let attribute attributes (name : string) = List.assoc_opt name attributes

let value attributes name =
  match attribute attributes name with None -> Rat.zero | Some text -> length text

let not_negative what q = if Rat.sign q < 0 then raise (Bad (what ^ " is negative")) else q

let polygons pen name attributes =
  let value = value attributes in
  let size name = not_negative name (value name) in
  match name with
  | "path" -> Svg_path.path pen (Option.value (attribute attributes "d") ~default:"")
  | "polygon" | "polyline" ->
    let rec pairs found = function
      | x :: y :: rest -> pairs ((x, y) :: found) rest
      | [ _ ] -> raise (Bad "points with an odd number of coordinates")
      | [] -> List.rev found
    in
    Svg_path.points pen (pairs [] (all (Option.value (attribute attributes "points") ~default:"")))
  | "circle" ->
    let r = size "r" in
    if Rat.sign r = 0 then [] else Svg_path.ellipse pen (value "cx", value "cy") r r
  | "ellipse" ->
    let rx = size "rx" and ry = size "ry" in
    if Rat.sign rx = 0 || Rat.sign ry = 0 then [] else Svg_path.ellipse pen (value "cx", value "cy") rx ry
  | "rect" ->
    let w = size "width" and h = size "height" in
    let radii =
      match (attribute attributes "rx", attribute attributes "ry") with
      | None, None -> (Rat.zero, Rat.zero)
      | Some _, None -> (size "rx", size "rx")
      | None, Some _ -> (size "ry", size "ry")
      | Some _, Some _ -> (size "rx", size "ry")
    in
    if Rat.sign w = 0 || Rat.sign h = 0 then [] else Svg_path.rectangle pen (value "x", value "y") (w, h) radii
  | _ -> []

(* {1 The picture} *)

(* Its size in pixels, and the map to them. *)
let frame ~resolution ~path attributes =
  let given name = Option.map length (attribute attributes name) in
  let x, y, w, h =
    match Option.map all (attribute attributes "viewBox") with
    | Some [ x; y; w; h ] -> (x, y, w, h)
    | Some _ -> raise (Bad "a viewBox without four numbers")
    | None -> (
        match (given "width", given "height") with
        | Some w, Some h -> (Rat.zero, Rat.zero, w, h)
        | _ -> raise (Bad "a drawing without a viewBox has to have a width and a height"))
  in
  if Rat.sign w <= 0 || Rat.sign h <= 0 then raise (Bad "the drawing has no size");
  let scale = Rat.div (Rat.of_int resolution) (Rat.max w h) in
  let pixels q = max 1 (Z.to_int (Z.neg (Rat.floor (Rat.neg (Rat.mul scale q))))) in
  let width = pixels w and height = pixels h in
  match Picture_fault.check_size ~path ~width ~height with
  | Error d -> raise (Refused d)
  | Ok () ->
    let to_pixels = Plane_map.(compose (scaling scale scale) (translation (Rat.neg x) (Rat.neg y))) in
    (Raster.create ~width ~height, to_pixels, (w, h))

(* What is around an element: its style, and its map to pixels; and the size of the view box. *)
type around = { style : Svg_style.t; map : Plane_map.t; size : Rat.t * Rat.t }

let paint raster ~budget here name attributes =
  let s = here.style in
  if s.displayed && s.shown then begin
    if Svg_style.stroked s then
      raise (Unread "strokes (turn them into paths, in Inkscape by Path, Stroke to Path, or set stroke to none)");
    match Svg_style.fill s with
    | Some colour ->
      Fill.polygons raster s.rule ~colour (polygons (Svg_path.pen ~budget here.map) name attributes)
    | None -> ()
  end

let enter around name attributes =
  let properties = Svg_declarations.of_element name attributes in
  let style = Svg_style.of_properties around.style properties in
  let own = Svg_transform.of_properties ~size:around.size properties in
  { around with style; map = Plane_map.compose around.map own }

let is_svg ns = ns = space || ns = ""
let refuse name cure = raise (Unread (Printf.sprintf "the element %S: %s" name cure))

(* The rest of an element whose start was read is passed over. *)
let pass_over input =
  let rec go depth =
    if depth > 0 then
      match Xmlm.input input with
      | `El_start _ -> go (depth + 1)
      | `El_end -> go (depth - 1)
      | `Data _ | `Dtd _ -> go depth
  in
  go 1

(* What is in a shape, which is to change nothing of it. *)
let rec shape_content input =
  match Xmlm.input input with
  | `El_end -> ()
  | `El_start ((ns, name), _) when is_svg ns && not (Svg_table.within_shape name) ->
    let cure = match Svg_table.element name with Refused cure -> cure | _ -> "it does not belong into a shape" in
    refuse name cure
  | `El_start _ -> pass_over input; shape_content input
  | `Data _ | `Dtd _ -> shape_content input

(* How the view box is fitted into the drawing changes its shape only if it is stretched or cut. *)
let check_ratio attributes =
  match attribute attributes "preserveAspectRatio" with
  | None -> ()
  | Some text ->
    let words = String.split_on_char ' ' (String.trim text) in
    if List.mem "none" words || List.mem "slice" words then
      raise (Unread (Printf.sprintf "preserveAspectRatio %S" text))

let draw ~resolution ~path input =
  let plain attributes =
    List.filter_map (fun ((ns, name), v) -> if ns = "" then Some (name, v) else None) attributes
  in
  let rec root () =
    match Xmlm.input input with
    | `Dtd (Some text) when String.contains text '[' ->
      raise (Unread "document types with declarations of their own")
    | `Dtd _ -> root ()
    | `El_start ((ns, "svg"), attributes) when is_svg ns -> plain attributes
    | _ -> raise (Unread "XML whose root is no svg element")
  in
  let attributes = root () in
  check_ratio attributes;
  let raster, map, size = frame ~resolution ~path attributes in
  let budget = ref max_corners in
  let rec content stack =
    if List.compare_length_with stack max_depth > 0 then raise (Bad "elements nested too deep");
    match (Xmlm.input input, stack) with
    | `El_end, [ _ ] -> ()
    | `El_end, _ :: outer -> content outer
    | `El_start ((ns, _), _), _ when not (is_svg ns) -> pass_over input; content stack
    | `El_start ((_, name), attributes), around :: _ -> (
        let attributes = plain attributes in
        match Svg_table.element name with
        | Silent -> pass_over input; content stack
        | Group -> content (enter around name attributes :: stack)
        | Shape ->
          paint raster ~budget (enter around name attributes) name attributes;
          shape_content input;
          content stack
        | Refused cure -> refuse name cure)
    | (`Data _ | `Dtd _), _ -> content stack
    | _, [] -> ()
  in
  let root = enter { style = Svg_style.initial; map = Plane_map.identity; size } "svg" attributes in
  if not (Plane_map.is_identity root.map) then
    raise (Unread "a transform of the whole drawing: put a `g` into it");
  content [ { root with map } ];
  raster

(* {1 Faults} *)

(* The byte at a line and column of characters, both from 1. *)
let offset text (line, column) =
  let n = String.length text in
  let rec start i line =
    if line <= 1 then i
    else match String.index_from_opt text i '\n' with Some j -> start (j + 1) (line - 1) | None -> n
  in
  let rec along i column =
    if column <= 1 || i >= n then min i n
    else
      let rec next j = if j < n && Char.code text.[j] land 0xc0 = 0x80 then next (j + 1) else j in
      along (next (i + 1)) (column - 1)
  in
  if n = 0 then 0 else along (start 0 line) column

let read ~resolution ~path text =
  let input = Xmlm.make_input (`String (0, text)) in
  let fault code ?hint at message =
    let at = offset text at in
    Error (Diag.error ?hint code (Span.make ~file:path ~start:at ~stop:at) "%s" message)
  in
  match draw ~resolution ~path input with
  | raster -> Ok raster
  | exception Refused d -> Error d
  | exception Xmlm.Error (at, error) ->
    fault Code.bad_picture at ("the XML is not well formed: " ^ Xmlm.error_message error)
  | exception Bad what -> fault Code.bad_picture (Xmlm.pos input) ("a fault in the drawing: " ^ what)
  | exception Unread what ->
    fault Code.picture_format (Xmlm.pos input) ("this is not read: " ^ what)
      ~hint:"filled paths, rectangles, circles, ellipses and polygons are read, in groups, with transforms"
