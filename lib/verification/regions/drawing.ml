open Scc_exact
open Scc_svg
open Scc_polyhedra
open Scc_calculus

(* {1 Places}

   In the picture: the plane from [left] on and from [top] down, the legend to the right of it. *)

let left = 80
let top = 48
let width = 440
let legend_left = left + width + 36
let legend_width = 300
let line_height = 18
let letters_wide = 7

let whole = Rat.of_int
let pixels n = string_of_int n

type frame = { ranges : Ranges.t; height : int; is_line : bool }

let frame ranges (view : Plane.view) =
  let is_line = view.up = None in
  { ranges = Legend.shown ranges view; height = (if is_line then 90 else width); is_line }

let part (r : Ranges.range) x = Rat.div (Rat.sub x r.low.value) (Rat.sub r.high.value r.low.value)

let place frame (p : Planar.point) =
  let x = Rat.mul (whole width) (part frame.ranges.(0) p.x) in
  let y = Rat.mul (whole frame.height) (part frame.ranges.(1) p.y) in
  (Rat.add (whole left) x, Rat.sub (whole (top + frame.height)) y)

let polygon frame p = List.map (place frame) (Planar.corners p)
let segment frame (a, b) = (place frame a, place frame b)

(* {1 Regions} *)

type drawn = {
  legend : Legend.t;
  outline : Outline.t;
  set : Union.t;
  polygons : (Rat.t * Rat.t) list list;
  id : string;
}

let drawn frame prefix i (legend, (r : Plane.region)) =
  let outline = Outline.make r.set in
  let polygons = List.map (polygon frame) outline.polygons in
  { legend; outline; set = r.set; polygons; id = Printf.sprintf "%s-%d" prefix i }

let around_each f = function
  | [] -> []
  | first :: _ as points -> List.map2 f points (List.tl points @ [ first ])

let total = List.fold_left Rat.add Rat.zero

(* Twice its area. *)
let doubled_area points =
  Rat.abs (total (around_each (fun (x, y) (x', y') -> Rat.sub (Rat.mul x y') (Rat.mul x' y)) points))

(* So narrow that filling it might show nothing: less than a pixel or so. *)
let is_thin points =
  let apart a b = Rat.abs (Rat.sub a b) in
  let around = total (around_each (fun (x, y) (x', y') -> Rat.add (apart x x') (apart y y')) points) in
  Rat.compare (doubled_area points) around < 0

let fill d =
  let path attributes = Svg.tag "path" (("d", Svg.closed d.polygons) :: attributes) [] in
  let thin = List.filter is_thin d.polygons in
  let stroke =
    [ ("fill", "none"); ("stroke", d.legend.colour); ("stroke-width", "2"); ("stroke-linecap", "round") ]
  in
  path [ ("fill", d.legend.colour); ("fill-opacity", "0.42") ]
  @ (if d.legend.hatched then path [ ("fill", "url(#" ^ d.id ^ "-hatch)") ] else [])
  @ if thin = [] then [] else Svg.tag "path" (("d", Svg.closed thin) :: stroke) []

let hatch d =
  let attributes =
    [ ("id", d.id ^ "-hatch"); ("width", "8"); ("height", "8"); ("patternUnits", "userSpaceOnUse") ]
  in
  let data = "M-2 2 L2 -2 M0 8 L8 0 M6 10 L10 6" in
  let line = [ ("d", data); ("stroke", d.legend.colour); ("stroke-width", "1.5") ] in
  if d.legend.hatched then Svg.tag "pattern" attributes (Svg.tag "path" line []) else []

let clip d =
  if d.polygons = [] then []
  else Svg.tag "clipPath" [ ("id", d.id ^ "-clip") ] (Svg.tag "path" [ ("d", Svg.closed d.polygons) ] [])

(* The upper and lower sides of a line are no borders of what is drawn. *)
let is_border frame (b : Outline.border) =
  let a, c = b.ends in
  not (frame.is_line && Rat.equal a.y c.y)

(* Lines are drawn with twice their width and cut off at the region, so that each region has its own side. *)
let borders frame d =
  let all = List.filter (is_border frame) d.outline.borders in
  let path belongs dashes =
    match List.filter (fun (b : Outline.border) -> b.belongs = belongs) all with
    | [] -> []
    | some ->
      let data = Svg.segments (List.map (fun (b : Outline.border) -> segment frame b.ends) some) in
      Svg.tag "path" (("d", data) :: dashes) []
  in
  let attributes =
    [
      ("clip-path", "url(#" ^ d.id ^ "-clip)"); ("fill", "none"); ("stroke", d.legend.colour);
      ("stroke-width", "4");
    ]
  in
  match path true [] @ path false [ ("stroke-dasharray", "5 4") ] with
  | [] -> []
  | paths -> Svg.tag "g" attributes paths

let region d = if d.polygons = [] then [] else Svg.tag "g" [] (Svg.title d.legend.told @ fill d)

let without_area frame d =
  let lines = List.map (segment frame) d.outline.lines in
  let path attributes = Svg.tag "path" ([ ("d", Svg.segments lines); ("fill", "none") ] @ attributes) [] in
  let point p =
    let x, y = place frame p in
    let at = [ ("cx", Svg.number x); ("cy", Svg.number y); ("r", "4.5") ] in
    Svg.tag "circle" (at @ [ ("class", "edge"); ("fill", d.legend.colour); ("stroke-width", "1") ]) []
  in
  let halo = [ ("class", "edge"); ("stroke-width", "6") ] in
  let line = [ ("stroke", d.legend.colour); ("stroke-width", "3.5") ] in
  match (if lines = [] then [] else path halo @ path line) @ List.concat_map point d.outline.points with
  | [] -> []
  | parts -> Svg.tag "g" [] (Svg.title d.legend.told @ parts)

(* {1 Corners} *)

let most_visible = 80

let corner frame all ~visible p =
  let owner = List.find_opt (fun d -> Planar.mem d.set p) all in
  let name i = frame.ranges.(i).name in
  let numbers, names =
    if frame.is_line then (Rat.to_string p.Planar.x, name 0)
    else
      ( Printf.sprintf "(%s, %s)" (Rat.to_string p.Planar.x) (Rat.to_string p.y),
        Printf.sprintf "(%s, %s)" (name 0) (name 1) )
  in
  let belongs = match owner with Some d -> d.legend.letter ^ ": " ^ d.legend.name | None -> "out of range" in
  let x, y = place frame p in
  let at = [ ("cx", Svg.number x); ("cy", Svg.number y) ] in
  let circle r attributes = Svg.tag "circle" (at @ (("r", r) :: attributes)) [] in
  let colour =
    match owner with
    | Some d -> [ ("class", "edge"); ("fill", d.legend.colour) ]
    | None -> [ ("class", "hollow") ]
  in
  Svg.tag "g" []
    (Svg.title (names ^ " = " ^ numbers ^ "\n" ^ belongs)
     @ circle "8" [ ("fill-opacity", "0") ]
     @ if visible then circle "3.2" (colour @ [ ("stroke-width", "1") ]) else [])

let corners frame all =
  let found = Outline.corners (List.map (fun d -> d.outline) all) in
  let shown = List.filter (fun (p : Planar.point) -> not frame.is_line || Rat.sign p.y = 0) found in
  let visible = List.compare_length_with shown most_visible <= 0 in
  List.concat_map (corner frame all ~visible) shown

(* {1 Names in their places} *)

(* Where a level line cuts the polygon. *)
let level points at =
  let cut (x, y) (x', y') =
    if Rat.compare (Rat.min y y') at <= 0 && Rat.compare at (Rat.max y y') <= 0 && not (Rat.equal y y') then
      [ Rat.add x (Rat.mul (Rat.div (Rat.sub at y) (Rat.sub y' y)) (Rat.sub x' x)) ]
    else []
  in
  match List.sort Rat.compare (List.concat (around_each cut points)) with
  | [] -> None
  | first :: _ as all -> Some (first, List.fold_left Rat.max first all)

(* The middle of the room for a text around the middle of a polygon, if it is wide enough. *)
let room points text =
  let count = whole (List.length points) in
  let middle = Rat.div (total (List.map snd points)) count in
  let half = whole 8 in
  let needed = whole ((letters_wide * String.length text) + 8) in
  match (level points (Rat.sub middle half), level points (Rat.add middle half)) with
  | Some (a, b), Some (c, d) ->
    let low = Rat.max a c and high = Rat.min b d in
    if Rat.compare (Rat.sub high low) needed < 0 then None
    else Some (text, Rat.div (Rat.add low high) (whole 2), middle)
  | _ -> None

let label d =
  let greatest_first a b = Rat.compare (doubled_area b) (doubled_area a) in
  let polygons = List.stable_sort greatest_first d.polygons in
  let try_text text = List.find_map (fun points -> room points text) polygons in
  let placed = match try_text d.legend.name with Some p -> Some p | None -> try_text d.legend.letter in
  match placed with
  | None -> []
  | Some (text, x, y) ->
    let at = [ ("x", Svg.number x); ("y", Svg.number (Rat.add y (Rat.of_int 5))) ] in
    Svg.text (at @ [ ("class", "ink"); ("text-anchor", "middle"); ("pointer-events", "none") ]) text

(* {1 Axes} *)

let shortened most text = if String.length text <= most then text else String.sub text 0 (most - 3) ^ "..."

let axis_name r =
  let text = Ranges.range_to_string r in
  if String.length text <= 50 then text else r.name

let tick attributes (x, y) (x', y') ~at ~anchor (m : Ticks.mark) =
  let tx, ty = at in
  Svg.tag "g" []
    (Svg.title m.exact
     @ Svg.tag "path" ([ ("d", Svg.segments [ ((x, y), (x', y')) ]); ("class", "axis") ] @ attributes) []
     @ Svg.text [ ("x", Svg.number tx); ("y", Svg.number ty); ("class", "ink"); ("text-anchor", anchor) ] m.label)

let across frame =
  let r = frame.ranges.(0) in
  let base = whole (top + frame.height) in
  let below n = Rat.add base (whole n) in
  let mark (m : Ticks.mark) =
    let x = Rat.add (whole left) (Rat.mul (whole width) (part r m.at)) in
    tick [] (x, base) (x, below 6) ~at:(x, below 22) ~anchor:"middle" m
  in
  let name =
    [
      ("x", pixels (left + (width / 2))); ("y", pixels (top + frame.height + 44)); ("class", "ink");
      ("text-anchor", "middle");
    ]
  in
  List.concat_map mark (Ticks.marks r) @ Svg.text name (axis_name r)

let up frame =
  let r = frame.ranges.(1) in
  let mark (m : Ticks.mark) =
    let y = Rat.sub (whole (top + frame.height)) (Rat.mul (whole frame.height) (part r m.at)) in
    tick [] (whole (left - 6), y) (whole left, y) ~at:(whole (left - 10), Rat.add y (whole 4)) ~anchor:"end" m
  in
  let middle = pixels (top + (frame.height / 2)) in
  let name =
    [
      ("x", "20"); ("y", middle); ("class", "ink"); ("text-anchor", "middle");
      ("transform", "rotate(-90 20 " ^ middle ^ ")");
    ]
  in
  List.concat_map mark (Ticks.marks r) @ Svg.text name (axis_name r)

(* {1 The legend} *)

let most_letters = (legend_width - 48) / letters_wide

let legend_text y text =
  let at = [ ("x", pixels (legend_left + 40)); ("y", pixels y); ("class", "ink") ] in
  let short = shortened most_letters text in
  Svg.tag "g" [] (Svg.title (if short = text then "" else text) @ Svg.text at short)

let swatch y d =
  let box attributes =
    Svg.tag "rect"
      ([ ("x", pixels legend_left); ("y", pixels y); ("width", "28"); ("height", "28"); ("rx", "3") ] @ attributes)
      []
  in
  let middle = [ ("x", pixels (legend_left + 14)); ("y", pixels (y + 19)); ("text-anchor", "middle") ] in
  box [ ("fill", d.legend.colour); ("fill-opacity", "0.42"); ("stroke", d.legend.colour) ]
  @ (if d.legend.hatched then box [ ("fill", "url(#" ^ d.id ^ "-hatch)") ] else [])
  @ Svg.text (("class", "ink") :: middle) d.legend.letter

(* In lines, as far as words are not too long by themselves. *)
let wrapped text =
  let add lines word =
    match lines with
    | line :: before when String.length line + 1 + String.length word <= most_letters ->
      (line ^ " " ^ word) :: before
    | lines -> word :: lines
  in
  List.rev (List.fold_left add [] (String.split_on_char ' ' text))

let most_lines = 6

(* Of the name of a region, whose share follows in one more line. *)
let name_lines d =
  let lines = wrapped d.legend.name in
  let kept = List.filteri (fun i _ -> i < most_lines) lines in
  if List.compare_length_with lines most_lines > 0 then kept @ [ "..." ] else kept

let entry y d =
  let line i text = legend_text (y + 11 + (i * line_height)) text in
  Svg.tag "g" [] (Svg.title d.legend.told @ swatch y d)
  @ List.concat (List.mapi line (name_lines d @ [ d.legend.share ]))

let entry_height d = 28 + (line_height * List.length (name_lines d))

let key y dashes text =
  let at x = (whole x, whole (y - 4)) in
  let line = Svg.segments [ (at legend_left, at (legend_left + 28)) ] in
  Svg.tag "path" ([ ("d", line); ("class", "axis"); ("stroke-width", "2") ] @ dashes) []
  @ legend_text y text

let keys_height = 62

let legend header all =
  let first = top + 22 in
  let add (y, entries) d = (y + entry_height d, entry y d :: entries) in
  let after, entries = List.fold_left add (first, []) all in
  let heading =
    Svg.text
      [ ("x", pixels legend_left); ("y", pixels (top + 8)); ("class", "ink"); ("font-weight", "bold") ]
      (shortened (legend_width / letters_wide) header)
  in
  heading
  @ List.concat (List.rev entries)
  @ key (after + 16) [] "border that belongs to the region"
  @ key (after + 16 + line_height) [ ("stroke-dasharray", "5 4") ] "border that does not"

let legend_height all = 22 + keys_height + List.fold_left (fun sum d -> sum + entry_height d) 0 all

(* {1 The file} *)

let style =
  [
    ".paper { fill: #ffffff; }"; ".ink { fill: #1f2328; }"; ".axis { stroke: #1f2328; fill: none; }";
    ".edge { stroke: #ffffff; }"; ".hollow { fill: #ffffff; stroke: #1f2328; }";
    "@media (prefers-color-scheme: dark) {"; "  .paper { fill: #15181c; }"; "  .ink { fill: #e6e8ea; }";
    "  .axis { stroke: #e6e8ea; }"; "  .edge { stroke: #15181c; }";
    "  .hollow { fill: #15181c; stroke: #e6e8ea; }";
    "}";
  ]

let remark =
  "<!-- A lossy export: places are rounded to 1/100 of a pixel. The titles of regions and corners are exact. -->"

(* Identifiers are to differ between pictures on one page. *)
let prefix_of texts = "w" ^ String.sub (Digest.to_hex (Digest.string (String.concat "\n" texts))) 0 8

let svg ?(values = []) ranges view checks =
  let frame = frame ranges view in
  let regions = Plane.regions ~values:(List.map snd values) ranges view (List.map snd checks) in
  let legends = Legend.make ~values ranges view (List.map fst checks) regions in
  let names = List.map fst checks @ List.map fst values in
  let caption = Legend.caption ranges view in
  let prefix = prefix_of (caption :: names @ List.map (fun (l : Legend.t) -> l.told) legends) in
  let all = List.mapi (drawn frame prefix) (List.combine legends regions) in
  let header = match names with [ name ] -> name | _ -> "what holds" in
  let total_width = legend_left + legend_width in
  let total_height = max (top + frame.height + 64) (top + legend_height all) in
  let size = [ pixels total_width; pixels total_height ] in
  let body =
    Svg.title ("where " ^ String.concat ", " names)
    @ [ remark ]
    @ Svg.tag "style" [] style
    @ Svg.tag "defs" [] (List.concat_map hatch all @ List.concat_map clip all)
    @ Svg.tag "rect" [ ("class", "paper"); ("width", List.nth size 0); ("height", List.nth size 1) ] []
    @ (if caption = "" then []
       else Svg.text [ ("x", pixels left); ("y", "28"); ("class", "ink") ] (shortened 100 caption))
    @ List.concat_map region all
    @ List.concat_map (borders frame) all
    @ List.concat_map (without_area frame) all
    @ List.concat_map label all
    @ across frame
    @ (if frame.is_line then [] else up frame)
    @ corners frame all @ legend header all
  in
  let attributes =
    [
      ("xmlns", "http://www.w3.org/2000/svg"); ("viewBox", String.concat " " ("0 0" :: size));
      ("width", List.nth size 0); ("height", List.nth size 1); ("role", "img");
      ("font-family", "system-ui, -apple-system, 'Segoe UI', 'DejaVu Sans', sans-serif"); ("font-size", "13");
    ]
  in
  String.concat "\n" (Svg.tag "svg" attributes body) ^ "\n"
