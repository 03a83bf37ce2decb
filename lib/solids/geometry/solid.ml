open Scc_base
open Scc_exact

type t = {
  id : int;
  polyhedron : Polyhedron.t;
  linear : Mat.t;
  vertices : Ivec.t array;
  denominator : Z.t;
  normals : Ivec.t array;
  topology : Topology.t;
  directions : Ivec.t array;
  shadow : Shadow.t;
  centroid : Vec.t;
  volume : Rat.t;
  inertia : Mat.t;
  radius : Rat.t;
  box : Float_box.t;
}

let position denominator (v : Ivec.t) =
  Vec.make (Rat.make v.x denominator) (Rat.make v.y denominator) (Rat.make v.z denominator)

let bound choose (vertices : Ivec.t array) =
  let merge (a : Ivec.t) (b : Ivec.t) = Ivec.make (choose a.x b.x) (choose a.y b.y) (choose a.z b.z) in
  Array.fold_left merge vertices.(0) vertices

let radius vertices denominator centroid =
  let far best v = Rat.max best (Vec.norm2 (Vec.sub (position denominator v) centroid)) in
  let farthest = Array.fold_left far Rat.zero vertices in
  Rat.sqrt_above farthest.Q.num farthest.den

let make ~id (polyhedron : Polyhedron.t) linear =
  if Rat.sign (Mat.det linear) <= 0 then Bug.fail __POS__ "a solid through a singular map or a reflection";
  let image (_, v) = Mat.apply linear v in
  let vertices, denominator = Ivec.of_vecs (Array.map image polyhedron.vertices) in
  let faces = Array.map snd polyhedron.faces in
  let mass = Mass_properties.of_surface vertices denominator faces in
  let normals = Array.map (fun f -> Ivec.primitive (Face_check.normal vertices f)) faces in
  let topology = polyhedron.topology in
  let direction (e : Topology.edge) = Ivec.primitive (Ivec.sub vertices.(e.head) vertices.(e.tail)) in
  let corners = Array.map (fun f -> vertices.(f.(0))) faces in
  let low = position denominator (bound Z.min vertices) in
  let high = position denominator (bound Z.max vertices) in
  {
    id;
    polyhedron;
    linear;
    vertices;
    denominator;
    normals;
    topology;
    directions = Array.map direction topology.edges;
    shadow = Shadow.make vertices denominator ~centroid:mass.centroid ~normals ~corners;
    centroid = mass.centroid;
    volume = mass.volume;
    inertia = mass.inertia;
    radius = radius vertices denominator mass.centroid;
    box = Float_box.of_corners low high;
  }

let derived = -1
let turned rotation s = make ~id:derived s.polyhedron (Mat.mul rotation s.linear)
let vertex s i = position s.denominator s.vertices.(i)

let corners s = function
  | Feature.Vertex i -> [ i ]
  | Feature.Edge i ->
    let v, w = s.polyhedron.edges.(i) in
    [ v; w ]
  | Feature.Face i -> Array.to_list (snd s.polyhedron.faces.(i))

let[@inline] get (a : float array) i = Array.unsafe_get a i

(* The loop where most of the time of a contact query goes does without checks: a shadow's arrays have as many
   entries as the solid has vertices, and the numbers of vertices come from the solid. Each factor that changes
   stands first, which saves the compiler a copy.

   The way leads uphill to a vertex without a higher neighbour, which in a convex solid is the highest. *)
let[@inline] uphill s dx dy dz ~from =
  let { Shadow.xs; ys; zs; compass; _ } = s.shadow and { Topology.first; neighbour; _ } = s.topology in
  let start = if from >= 0 then from else Compass.look compass dx dy dz in
  let at = ref (-1) and best = ref start in
  let height = ref ((get xs start *. dx) +. (get ys start *. dy) +. (get zs start *. dz)) in
  while !at <> !best do
    at := !best;
    for k = Array.unsafe_get first !at to Array.unsafe_get first (!at + 1) - 1 do
      let i = Array.unsafe_get neighbour k in
      let h = (get xs i *. dx) +. (get ys i *. dy) +. (get zs i *. dz) in
      if h > !height then begin
        best := i;
        height := h
      end
    done
  done;
  !best

let highest s (direction : float array) sign =
  let dz = direction.(2) *. sign in
  let dx = get direction 0 *. sign and dy = get direction 1 *. sign in
  uphill s dx dy dz ~from:(-1)
