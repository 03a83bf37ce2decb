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
    (Raster.create ~width ~height, to_pixels)

(* What is around an element: its style, and its map to pixels. *)
type around = { style : Svg_style.t; map : Plane_map.t }


let paint raster ~budget here name attributes =
  let s = here.style in
  if s.displayed && s.shown then begin
    if s.stroked then raise (Unread "strokes (turn them into paths, or set stroke to none)");
    match s.fill with
    | Some colour when Rat.compare s.opacity Rat.half >= 0 ->
      Fill.polygons raster s.rule ~colour (polygons (Svg_path.pen ~budget here.map) name attributes)
    | _ -> ()
  end

let enter around attributes =
  let style = Svg_style.of_element around.style attributes in
  let map =
    match attribute attributes "transform" with
    | None -> around.map
    | Some text -> Plane_map.compose around.map (Svg_style.transform text)
  in
  { style; map }

let groups = [ "g"; "a" ]
let shapes = [ "path"; "rect"; "circle"; "ellipse"; "polygon"; "polyline" ]

(* Elements that paint nothing by themselves, with all that is in them. *)
let silent =
  [
    "title"; "desc"; "metadata"; "defs"; "line"; "clipPath"; "mask"; "linearGradient"; "radialGradient"; "filter";
    "symbol"; "marker"; "pattern"; "script";
  ]

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

let draw ~resolution ~path input =
  let plain attributes =
    List.filter_map (fun ((ns, name), v) -> if ns = "" then Some (name, v) else None) attributes
  in
  let rec root () =
    match Xmlm.input input with
    | `Dtd (Some text) when String.contains text '[' ->
      raise (Unread "document types with declarations of their own")
    | `Dtd _ -> root ()
    | `El_start ((ns, "svg"), attributes) when ns = space || ns = "" -> plain attributes
    | _ -> raise (Unread "XML whose root is no svg element")
  in
  let attributes = root () in
  let raster, map = frame ~resolution ~path attributes in
  let budget = ref max_corners in
  let rec content stack =
    if List.compare_length_with stack max_depth > 0 then raise (Bad "elements nested too deep");
    match (Xmlm.input input, stack) with
    | `El_end, [ _ ] -> ()
    | `El_end, _ :: outer -> content outer
    | `El_start ((ns, _), _), _ when ns <> space && ns <> "" -> pass_over input; content stack
    | `El_start ((_, name), attributes), around :: _ ->
      let attributes = plain attributes in
      if List.mem name silent then begin pass_over input; content stack end
      else if List.mem name groups then content (enter around attributes :: stack)
      else if List.mem name shapes then begin
        paint raster ~budget (enter around attributes) name attributes;
        pass_over input;
        content stack
      end
      else raise (Unread (Printf.sprintf "the element %S" name))
    | (`Data _ | `Dtd _), _ -> content stack
    | _, [] -> ()
  in
  content [ { style = Svg_style.of_element Svg_style.initial attributes; map } ];
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
