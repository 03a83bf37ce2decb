open Scc_exact
open Scc_geometry

type gaps = { solution : Rat.t; surface : Rat.t; outline : Rat.t }
type t = { mesh : Polyhedron.ifs; holes : int; gaps : gaps }

let cells (r : Relief.t) f =
  for j = 0 to r.shape.height - 2 do
    for i = 0 to r.shape.width - 2 do
      List.iter f (Front.triangles r i j)
    done
  done

let everything r =
  let n = ref 0 in
  cells r (fun _ -> incr n);
  2 * !n

(* By their places in the plane. *)
module Corners = Scc_data.Numbering.Make (struct
    type t = Front.corner

    let equal (a : t) (b : t) = a.x = b.x && a.y = b.y
    let hash (c : t) = Hashtbl.hash (c.x, c.y)
  end)

(* The front as corners and triangles of them. *)
let all_of r =
  let corners = Corners.create () and found = ref [] in
  let number = Corners.number corners in
  cells r (fun (p, q, s) ->
      let p = number p in
      let q = number q in
      found := (p, q, number s) :: !found);
  (Array.of_list (Corners.keys corners), List.rev !found)

let simple t =
  ( Array.init (Triangulation.vertices t) (Triangulation.vertex t),
    List.init (Triangulation.triangles t) (Triangulation.corners t) )

(* Places are in eighths of a pixel from the centre of the pixel (0, 0) of the rectangle; those of the picture have
   their corner at its left top. *)
let place (r : Relief.t) ~scale (c : Front.corner) z =
  let s = r.shape in
  let unit = Front.unit in
  let eighths n = Rat.make (Z.of_int n) (Z.of_int unit) in
  let x = c.x + (unit * s.left) + (unit / 2) - (unit * s.picture.width / 2) in
  let y = c.y + (unit * s.top) + (unit / 2) - (unit * s.picture.height / 2) in
  Vec.scale scale (Vec.make (eighths x) (eighths (-y)) (Rat.make (Z.of_int z) (Z.of_int Relief.quanta)))

let sew r ~scale (corners, front) =
  let n = Array.length corners in
  let next = ref n in
  let behind =
    Array.mapi
      (fun v (c : Front.corner) ->
         if c.z = 0 then v
         else begin
           incr next;
           !next - 1
         end)
      corners
  in
  let vertices = Array.make !next ("", Vec.zero) in
  let put v c z = vertices.(v) <- (Printf.sprintf "v%d" v, place r ~scale c z) in
  Array.iteri (fun v (c : Front.corner) -> put v c c.z; if c.z > 0 then put behind.(v) c (-c.z)) corners;
  let back = List.rev_map (fun (a, b, c) -> [| behind.(a); behind.(c); behind.(b) |]) front in
  let front = List.map (fun (a, b, c) -> [| a; b; c |]) front in
  let faces = Array.of_list (List.rev_append (List.rev front) (List.rev back)) in
  { Polyhedron.ifs_vertices = vertices; ifs_faces = Array.mapi (fun k f -> (Printf.sprintf "f%d" k, f)) faces }

let quanta n = Rat.make (Z.of_int n) (Z.of_int Relief.quanta)

let whole r ~scale ~holes =
  {
    mesh = sew r ~scale (all_of r);
    holes;
    gaps = { solution = r.Relief.off; surface = Rat.zero; outline = Rat.zero };
  }

(* Half of the triangles are for the outline's corners at most: of a third as many corners there are about as many
   within, where the surface is met. Fewer corners when that is too many. *)
let simplified ~progress r ~scale ~faces loops =
  let holes = List.length loops - 1 in
  let most = faces / 2 in
  let fewest = 3 * (holes + 1) in
  let rec attempt corners =
    let outline = Outline.simplify r.Relief.shape ~most:corners loops in
    match Refine.reaching ~progress r outline.loops ~most with
    | Ok t ->
      let gaps =
        { solution = r.off; surface = quanta (Gap.between r t); outline = quanta outline.off }
      in
      Ok { mesh = sew r ~scale (simple t); holes; gaps }
    | Error _ when corners > fewest && Outline.corners outline.loops <= corners ->
      attempt (max fewest (corners * 3 / 4))
    | Error needed -> Error (2 * needed)
  in
  attempt (max fewest (most / 3))

let make ~progress ~faces ~scale r =
  let loops = Outline.trace r.Relief.shape in
  match faces with
  | Some n when n < everything r -> simplified ~progress r ~scale ~faces:n loops
  | Some _ | None -> Ok (whole r ~scale ~holes:(List.length loops - 1))

let together solids =
  let start = ref 0 in
  let one t =
    let from = !start in
    start := from + Array.length t.mesh.Polyhedron.ifs_vertices;
    Array.map (fun (_, face) -> Array.map (( + ) from) face) t.mesh.ifs_faces
  in
  let faces = Array.concat (List.map one solids) in
  let vertices = Array.concat (List.map (fun t -> t.mesh.Polyhedron.ifs_vertices) solids) in
  let named letter = Array.mapi (fun k x -> (Printf.sprintf "%c%d" letter k, x)) in
  let greatest f = List.fold_left (fun q t -> Rat.max q (f t.gaps)) Rat.zero solids in
  {
    mesh = { ifs_vertices = named 'v' (Array.map snd vertices); ifs_faces = named 'f' faces };
    holes = List.fold_left (fun n t -> n + t.holes) 0 solids;
    gaps =
      {
        solution = greatest (fun g -> g.solution);
        surface = greatest (fun g -> g.surface);
        outline = greatest (fun g -> g.outline);
      };
  }
