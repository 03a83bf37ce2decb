open Scc_exact
open Scc_geometry
open Scc_rigid
open Scc_svg

let hatch_colour = "#1f2328"
let bond_colour = "#1f2328"

let period (t : Paint.t) = Float.max 2.5 (5. *. t.stroke)

(* Of two pictures on one page equal identifiers are of equal patterns. *)
let hatch t = "open-" ^ String.map (fun c -> if c = '.' then '-' else c) (Paint.pixels (period t))

let pattern t =
  let period = period t in
  let wide = Paint.pixels period in
  let size = [ ("id", hatch t); ("patternUnits", "userSpaceOnUse"); ("width", wide); ("height", wide) ] in
  let turn = [ ("patternTransform", "rotate(45)") ] in
  let line = [ ("x1", "0"); ("y1", "0"); ("x2", "0"); ("y2", wide) ] in
  let stroke = [ ("stroke", hatch_colour); ("stroke-width", Paint.pixels (0.32 *. period)) ] in
  Svg.tag "pattern" (size @ turn) (Svg.tag "line" (line @ stroke @ [ ("stroke-opacity", "0.7") ]) [])

let circle (x, y) radius attributes =
  Svg.tag "circle" ([ ("cx", Svg.number x); ("cy", Svg.number y); ("r", Paint.pixels radius) ] @ attributes) []

(* {1 Open features} *)

let none = function [] -> true | _ :: _ -> false

let open_features (t : Paint.t) colour body placed features =
  let view = Hidden.view t.hidden in
  let is_open f = List.exists (Feature.equal f) features in
  let face i =
    if not (is_open (Face view.faces.(i).face)) then []
    else
      match Hidden.pieces t.hidden i with
      | [] -> []
      | pieces -> Svg.tag "path" [ ("d", Paint.region t pieces); ("fill", "url(#" ^ hatch t ^ ")") ] []
  in
  let edge i =
    let e = view.edges.(i) in
    if is_open (Edge e.edge) then Hidden.segments t.hidden e else []
  in
  let vertex = function
    | Feature.Vertex v ->
      let p = Placed.point placed (Solid.vertex placed.solid v) in
      let stroke = [ ("fill", "#ffffff"); ("stroke", hatch_colour); ("stroke-width", "1.2") ] in
      (match Paint.place t p with
       | Some at when Paint.shows t p -> circle at 3. stroke
       | Some _ | None -> [])
    | Edge _ | Face _ -> []
  in
  let edges =
    match List.concat_map edge t.edges.(body) with
    | [] -> []
    | segments ->
      let data = [ ("d", Paint.lines t segments); ("fill", "none") ] in
      let stroke colour width = [ ("stroke", colour); ("stroke-width", width) ] in
      Svg.tag "path" (data @ stroke hatch_colour "4.4") []
      @ Svg.tag "path" (data @ stroke (Palette.hex (Palette.mix colour Palette.white 0.6)) "2") []
  in
  List.concat_map face t.faces.(body) @ edges @ List.concat_map vertex features

(* {1 Bonds} *)


let middle placed feature =
  let corners = Placed.corners placed feature in
  Vec.scale
    (Rat.make Z.one (Z.of_int (List.length corners)))
    (List.fold_left Vec.add Vec.zero corners)

let drawn_bond ~told contact ends =
  let data = Svg.segments (List.map (fun p -> (p, contact)) ends) in
  let line colour width more =
    Svg.tag "path" ([ ("d", data); ("fill", "none"); ("stroke", colour); ("stroke-width", width) ] @ more) []
  in
  let dashes = [ ("stroke-dasharray", "4 3"); ("stroke-linecap", "butt") ] in
  let rim = [ ("fill", bond_colour); ("stroke", "#ffffff"); ("stroke-width", "1") ] in
  Svg.tag "g" [] (Svg.title told @ line "#ffffff" "3" [] @ line bond_colour "1.4" dashes @ circle contact 3.2 rim)

let bond t ~told (one, feature) (two, other) =
  match Paint.place t (Vec.middle (middle one feature) (middle two other)) with
  | None -> []
  | Some contact ->
    drawn_bond ~told contact (List.filter_map (fun p -> Paint.place t (Placed.centroid p)) [ one; two ])

(* {1 Names} *)

type name = { text : string; at : (Rat.t * Rat.t) list; size : float; style : (string * string) list }

let letter_wide = 7
let letter_high = 13

type box = { left : float; right : float; low : float; high : float }

let box name (x, y) =
  let x = Rat.to_float x and y = Rat.to_float y in
  let wide = float_of_int (letter_wide * String.length name.text) /. 2. in
  let high = float_of_int letter_high /. 2. in
  { left = x -. wide; right = x +. wide; low = y -. high; high = y +. high }

let meet a b = a.left < b.right && b.left < a.right && a.low < b.high && b.low < a.high

let written (name, (x, y)) =
  Svg.text
    ([ ("x", Svg.number x); ("y", Svg.number (Rat.add y (Rat.of_int 4))) ] @ name.style)
    name.text

(* Names stay within the picture, which is so wide. *)
let inside width name (x, y) =
  let half = Rat.of_int ((letter_wide * String.length name.text / 2) + 2) in
  (Rat.max half (Rat.min x (Rat.sub (Rat.of_int width) half)), y)

let names ~width names =
  let order a b = Float.compare b.size a.size in
  let put (taken, found) name =
    let free p = not (List.exists (meet (box name p)) taken) in
    match List.find_opt free (List.map (inside width name) name.at) with
    | None -> (taken, found)
    | Some p -> (box name p :: taken, (name, p) :: found)
  in
  let _, found = List.fold_left put ([], []) (List.stable_sort order names) in
  if none found then []
  else
    let halo = [ ("stroke", "#ffffff"); ("stroke-width", "2.5"); ("stroke-opacity", "0.8") ] in
    let how = [ ("paint-order", "stroke"); ("stroke-linejoin", "round"); ("text-anchor", "middle") ] in
    let font = [ ("font-size", "12"); ("fill", "#1f2328") ] in
    Svg.tag "g" (halo @ how @ font) (List.concat_map written (List.rev found))
