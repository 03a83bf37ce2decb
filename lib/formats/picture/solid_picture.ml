open Scc_exact
open Scc_geometry
open Scc_svg

type options = { from : Vec.t; up : Vec.t; width : int }

let default = { from = Picture.default.from; up = Picture.default.up; width = 900 }
let none = function [] -> true | _ :: _ -> false

(* Each pair of vertices that some face goes along, once, in order; what is no vertex is left out. *)
let edges_of (set : Polyhedron.ifs) =
  let count = Array.length set.ifs_vertices in
  let there v = v >= 0 && v < count in
  let of_face (_, corners) =
    let n = Array.length corners in
    let side i =
      let v = corners.(i) and w = corners.((i + 1) mod n) in
      (min v w, max v w)
    in
    List.filter (fun (v, w) -> there v && there w && v <> w) (List.init n side)
  in
  let order (a, b) (c, d) = match Int.compare a c with 0 -> Int.compare b d | first -> first in
  List.sort_uniq order (List.concat_map of_face (Array.to_list set.ifs_faces))

(* {1 One side} *)

type side = {
  report : Solid_report.t;
  witnesses : Witness.t list;
  soup : Soup.t;
  paint : Paint.t;
  edges : (int * int) list;
}

let caption_high = 20

let see ~width ~top ~up report witnesses edges from =
  let camera = Camera.make ~up from in
  let set = report.Solid_report.set in
  let positions = Array.map snd set.ifs_vertices in
  let origin =
    if Array.length positions = 0 then Ivec.zero
    else
      let p = positions.(0) in
      Ivec.make (Rat.floor p.x) (Rat.floor p.y) (Rat.floor p.z)
  in
  let soup = Soup.make camera ~origin positions (Array.map snd set.ifs_faces) in
  let points = match Array.to_list soup.points.flat with [] -> [ Convex.point Z.zero Z.zero Z.one ] | all -> all in
  let canvas = Canvas.make camera ~width ~margin:(2 * Sheet.margin) ~top points in
  let paint = Paint.make camera ~origin canvas (Hidden.make soup.view) in
  { report; witnesses; soup; paint; edges }

let ink = "#1f2328"
let quiet = "#57606a"
let alarm = (0.84, 0.2, 0.0)
let outer_colour = (0.50, 0.76, 0.92)
let inner_colour = (0.90, 0.84, 0.66)
let accused_outer = (0.97, 0.64, 0.54)
let accused_inner = (0.93, 0.58, 0.28)
let at s v = s.soup.points.flat.(v)
let shown s v = Hidden.shows s.paint.hidden (at s v) ~depth:(View.depth s.soup.points v)
let on_paper s v = s.paint.canvas.place (at s v)

(* {1 Faces} *)

let accused s face = List.exists (fun (w : Witness.t) -> List.mem face w.faces) s.witnesses

(* The parts of the view that belong to each face, in order. *)
let parts s =
  let lists = Array.make (Array.length s.report.set.ifs_faces) [] in
  let faces = s.soup.view.faces in
  for i = Array.length faces - 1 downto 0 do
    lists.(faces.(i).face) <- i :: lists.(faces.(i).face)
  done;
  lists

let seen s i = Hidden.pieces s.paint.hidden i

let face s parts f =
  let fill i =
    let of_view = s.soup.view.faces.(i) in
    let base =
      match (Soup.inner of_view, accused s f) with
      | false, false -> outer_colour
      | true, false -> inner_colour
      | false, true -> accused_outer
      | true, true -> accused_inner
    in
    Palette.hex (Paint.shade s.paint base of_view)
  in
  (* Parts of one colour are one region, so that no seams are seen between them. *)
  let add found i =
    match (seen s i, fill i, found) with
    | [], _, _ -> found
    | pieces, fill, (last, before) :: rest when String.equal fill last -> (last, pieces @ before) :: rest
    | pieces, fill, _ -> (fill, pieces) :: found
  in
  let paint (fill, pieces) =
    Svg.tag "path" [ ("d", Paint.region s.paint pieces); ("fill", fill); ("stroke", fill) ] []
  in
  match List.concat_map paint (List.rev (List.fold_left add [] parts)) with
  | [] -> []
  | painted -> Svg.tag "g" [ ("stroke-width", "0.5") ] (Svg.title (Solid_report.face_name s.report f) @ painted)

(* {1 Edges} *)

let uncovered s (v, w) =
  if Ivec.equal (at s v) (at s w) then []
  else
    let depth = View.depth s.soup.points in
    Hidden.uncovered s.paint.hidden (at s v, depth v) (at s w, depth w)

let path s segments attributes =
  match segments with
  | [] -> []
  | _ :: _ -> Svg.tag "path" ([ ("d", Paint.lines s.paint segments); ("fill", "none") ] @ attributes) []

let strokes colour width = [ ("stroke", colour); ("stroke-width", width) ]
let dashes = [ ("stroke-dasharray", "4 4"); ("stroke-linecap", "butt") ]

(* Beyond so many edges those that are hidden only confuse, and the others are thin. *)
let most_dashed = 200

(* All of them dashed, and over that what is seen of them. *)
let edges s =
  let many = List.compare_length_with s.edges most_dashed > 0 in
  let whole (v, w) = (at s v, at s w) in
  let hidden = if many then [] else List.map whole s.edges in
  path s hidden (strokes quiet "0.7" @ dashes @ [ ("stroke-opacity", "0.6") ])
  @ path s (List.concat_map (uncovered s) s.edges) (strokes ink (if many then "0.6" else "1.2"))

(* {1 Witnesses} *)

let alarm_hex = Palette.hex alarm

let circle (x, y) radius attributes =
  Svg.tag "circle" ([ ("cx", Svg.number x); ("cy", Svg.number y); ("r", radius) ] @ attributes) []

let witness s (w : Witness.t) =
  let outline f =
    let corners = snd s.report.set.ifs_faces.(f) in
    let n = Array.length corners in
    let there v = v >= 0 && v < Array.length s.soup.points.flat in
    let side i = (corners.(i), corners.((i + 1) mod n)) in
    List.filter (fun (v, w) -> there v && there w && v <> w) (List.init n side)
  in
  let border = List.concat_map outline w.faces in
  let line width (v, w) =
    path s [ (at s v, at s w) ] (strokes alarm_hex width @ dashes)
    @ path s (uncovered s (v, w)) (strokes alarm_hex width)
  in
  let vertex v =
    let fill = if shown s v then alarm_hex else "#ffffff" in
    circle (on_paper s v) "4.5" (("fill", fill) :: strokes alarm_hex "1.6")
  in
  List.concat_map (line "1.4") border @ List.concat_map (line "3.6") w.edges @ List.concat_map vertex w.vertices

let badge text =
  let circle = circle (Rat.zero, Rat.zero) "10" [ ("fill", "#ffffff"); ("stroke", alarm_hex) ] in
  let at = [ ("x", "0"); ("y", "4"); ("text-anchor", "middle"); ("font-size", "11"); ("font-weight", "bold") ] in
  circle @ Svg.text (at @ [ ("fill", alarm_hex); ("stroke", "none") ]) text

let mean (x, y) (x', y') = (Rat.middle x x', Rat.middle y y')

(* The largest pieces that are seen of a face, the greatest first, and twice their area in all. *)
let largest s parts f =
  let pieces = List.concat_map (seen s) parts.(f) in
  let sized = List.map (fun p -> (Rat.near_float (Convex.area2 p), p)) pieces in
  let sorted = List.stable_sort (fun (a, _) (b, _) -> Float.compare b a) sized in
  (List.map snd sorted, List.fold_left (fun sum (a, _) -> sum +. a) 0. sized)

let is_seen s parts f = List.exists (fun i -> not (none (seen s i))) parts.(f)

(* Where the badges of a witness are, for each of its features. [elsewhere] tells which faces are seen from the
   other side. *)
let anchors s ~elsewhere parts (w : Witness.t) =
  let face f =
    match fst (largest s parts f) with
    | p :: _ -> Some (s.paint.canvas.place (Convex.middle p))
    | [] when elsewhere f -> None
    | [] -> (
        let there v = v >= 0 && v < Array.length s.soup.points.flat in
        match List.filter there (Array.to_list (snd s.report.set.ifs_faces.(f))) with
        | [] -> None
        | v :: _ as all -> Some (mean (on_paper s v) (on_paper s (List.nth all (List.length all / 2)))))
  in
  match (w.vertices, w.edges) with
  | (_ :: _ as vertices), _ -> List.map (on_paper s) vertices
  | [], (_ :: _ as edges) -> List.map (fun (v, w) -> mean (on_paper s v) (on_paper s w)) edges
  | [], [] -> List.filter_map face w.faces

(* Badges step aside where others are. *)
let badges s ~elsewhere parts =
  let near = [ (16, -16); (16, 16); (-16, -16); (-16, 16) ] in
  let steps = near @ [ (38, -16); (38, 16); (-38, -16); (-38, 16); (0, -38) ] in
  let far (a, b) (c, d) =
    let dx = Rat.to_float (Rat.sub a c) and dy = Rat.to_float (Rat.sub b d) in
    (dx *. dx) +. (dy *. dy) > 440.
  in
  let put (w : Witness.t) (taken, found) (x, y) =
    let moved (dx, dy) = (Rat.add x (Rat.of_int dx), Rat.add y (Rat.of_int dy)) in
    let free p = List.for_all (far p) taken in
    let p = Option.value ~default:(moved (16, -16)) (List.find_opt free (List.map moved steps)) in
    let at = Printf.sprintf "translate(%s %s)" (Svg.number (fst p)) (Svg.number (snd p)) in
    let line = Svg.tag "path" (("d", Svg.segments [ ((x, y), p) ]) :: strokes alarm_hex "0.8") [] in
    (p :: taken, found @ line @ Svg.tag "g" [ ("transform", at) ] (Svg.title w.text @ badge w.badge))
  in
  let all found w = List.fold_left (put w) found (anchors s ~elsewhere parts w) in
  snd (List.fold_left all ([], []) s.witnesses)

(* {1 Names} *)

(* Of more vertices only those have names that are witnesses. *)
let most_named = 60

let names s parts =
  (* A name is on its face: one that is too small for it has none. *)
  let room name piece =
    let places = List.map s.paint.canvas.place (Array.to_list piece) in
    let extent f =
      let all = List.map (fun p -> Rat.to_float (f p)) places in
      List.fold_left Float.max neg_infinity all -. List.fold_left Float.min infinity all
    in
    extent fst > float_of_int (7 * String.length name) && extent snd > 14.
  in
  let face f (name, _) : Marks.name option =
    let pieces, size = largest s parts f in
    match List.filter (room name) (List.filteri (fun i _ -> i < 4) pieces) with
    | [] -> None
    | pieces ->
      let at = List.map (fun p -> s.paint.canvas.place (Convex.middle p)) pieces in
      Some { text = name; at; size; style = [] }
  in
  let witnesses = List.concat_map (fun (w : Witness.t) -> w.vertices) s.witnesses in
  let few = Array.length s.report.set.ifs_vertices <= most_named in
  let named v = (few || List.mem v witnesses) && shown s v in
  let middle = Rat.make (Z.of_int s.paint.canvas.width) (Z.of_int 2) in
  let vertex v (name, _) : Marks.name option =
    if not (named v) then None
    else
      let x, y = on_paper s v in
      let away = if Rat.compare x middle < 0 then -12 else 12 in
      let moved (dx, dy) = (Rat.add x (Rat.of_int dx), Rat.add y (Rat.of_int dy)) in
      let at = List.map moved [ (away, 0); (away, -10); (away, 10); (0, -12); (0, 12); (-away, 0) ] in
      let style = [ ("font-size", "11"); ("font-style", "italic"); ("fill", quiet) ] in
      Some { text = name; at; size = 0.; style }
  in
  let all f named = List.filter_map Fun.id (Array.to_list (Array.mapi f named)) in
  Marks.names ~width:s.paint.canvas.width (all face s.report.set.ifs_faces @ all vertex s.report.set.ifs_vertices)

(* {1 Both} *)

let draw s ~other ~left ~top caption =
  let parts = parts s and elsewhere = is_seen other (parts other) in
  let at = [ ("x", string_of_int Sheet.margin); ("y", string_of_int (top - 2)) ] in
  let told = Svg.text (at @ [ ("fill", quiet) ]) caption in
  let faces = List.concat (List.mapi (fun f parts -> face s parts f) (Array.to_list parts)) in
  let accused = List.concat_map (witness s) s.witnesses in
  Svg.tag "g"
    [ ("transform", Printf.sprintf "translate(%d 0)" left) ]
    (told @ faces @ edges s @ accused @ names s parts @ badges s ~elsewhere parts)

let notes (r : Solid_report.t) witnesses =
  let p = r.paper in
  let sizes = Printf.sprintf "%d vertices, %d edges, %d faces" p.vertices p.edges p.faces in
  let plain text : Key.note = { badge = []; text } in
  match r.verdict with
  | Accepted (_, mass) ->
    let volume = Decimal.in_short ~most:64 mass.volume in
    [ plain (Printf.sprintf "A convex closed polyhedron: %s, volume %s." sizes volume) ]
  | Rejected _ ->
    let note (w : Witness.t) : Key.note = { badge = badge w.badge; text = w.text } in
    let more = Witness.more r in
    (plain (Printf.sprintf "Not a convex closed polyhedron: %s." sizes) :: List.map note witnesses)
    @ if more > 0 then [ plain (Printf.sprintf "and %d more faults" more) ] else []

let key sides : Key.entry list =
  let swatch text colour : Key.entry =
    { sample = Swatch { fill = Palette.hex colour; stroke = Palette.hex (Paint.ink colour) }; text }
  in
  let inner s = List.exists (fun i -> Soup.inner s.soup.view.faces.(i) && not (none (seen s i))) in
  let shows_inner s = inner s (List.init (Array.length s.soup.view.faces) Fun.id) in
  if List.exists shows_inner sides then
    [ swatch "outer side" outer_colour; swatch "inner side" inner_colour ]
  else []

(* At most so many letters, those at the end of a long path. *)
let ending letters text =
  let n = String.length text in
  if n <= letters then text
  else
    let rec boundary i = if i < n && Char.code text.[i] land 0xC0 = 0x80 then boundary (i + 1) else i in
    let from = boundary (n - letters) in
    "..." ^ String.sub text from (n - from)

let svg ~name options (report : Solid_report.t) =
  let witnesses = Witness.all report in
  let width = options.width / 2 in
  let top = Sheet.top ~title:(Some name) + caption_high in
  let see = see ~width ~top ~up:options.up report witnesses (edges_of report.set) in
  let one = see options.from and two = see (Vec.neg options.from) in
  let sheet : Sheet.t =
    {
      size = (options.width, max one.paint.canvas.height two.paint.canvas.height);
      title = Some (ending (options.width / 9) name);
      told = name;
      defs = [];
      bar = (if none (edges_of report.set) then None else Some one.paint.canvas);
      key = key [ one; two ];
      notes = notes report witnesses;
    }
  in
  let top = top + 4 in
  Sheet.svg sheet
    (draw one ~other:two ~left:0 ~top ("seen from " ^ Vec.to_string options.from)
     @ draw two ~other:one ~left:width ~top "seen from the other side")
