open Scc_exact
open Scc_geometry

type t = {
  first : Placed.t;
  second : Placed.t;
  gap : Vec.t;
  normals : Ivec.t list;
  corners : Vec.t list;
  pairs : Contact.pair list;
  highest : Contact.pair;
  plane : Ivec.t * Rat.t;
}

let in_resolution ~resolution d = Rat.compare (Vec.norm2 d) (Rat.mul resolution resolution) <= 0

let distance2 a b =
  let va, vb, denominator = Placed.over_one a b in
  Vec.norm2 (Closest.vector_over denominator va vb)

let within ~resolution p q =
  in_resolution ~resolution (Closest.vector (Array.of_list p) (Array.of_list q))

(* {1 Solids that touch} *)

let touching (a : Placed.t) (b : Placed.t) =
  let o = Obstacle.make (Placed.fixed_solid a) (Placed.fixed_solid b) in
  let r = Vec.sub b.at a.at in
  match Obstacle.relation o r with
  | Apart | Interpenetrating -> Scc_base.Bug.fail __POS__ "two bodies interpenetrate"
  | Touching ->
    let normals = Obstacle.separating o r in
    let corners = List.map (Vec.add a.at) (Contact.region o r) in
    let n = Ivec.primitive (List.fold_left Ivec.add Ivec.zero normals) in
    {
      first = a;
      second = b;
      gap = Vec.zero;
      normals;
      corners;
      pairs = Contact.touching o r;
      highest = Contact.highest o r;
      plane = (n, Vec.dot (Ivec.to_vec n) (List.hd corners));
    }

(* {1 Solids that are apart} *)

(* The feature that has these vertices, or the smallest one that holds them all. *)
let holding (s : Solid.t) = function
  | [] -> None
  | [ v ] -> Some (Feature.Vertex v)
  | v :: w :: rest as vs -> (
      match (rest, Topology.edge_between s.topology v w) with
      | [], Some e -> Some (Feature.Edge e)
      | _ ->
        let has (_, corners) = List.for_all (fun v -> Array.exists (Int.equal v) corners) vs in
        let faces = s.polyhedron.faces in
        List.find_opt (fun f -> has faces.(f)) (List.init (Array.length faces) Fun.id)
        |> Option.map (fun f -> Feature.Face f))

(* All in the units of twice n.v: [sum] is that of the middle, [reach2] the square of the resolution. *)
let contact_feature (s : Solid.t) n vertices ~sum ~reach2 =
  let distances = Array.map (fun v -> Z.abs (Z.sub (Z.shift_left (Ivec.dot n v) 1) sum)) vertices in
  let those keep =
    List.filter (fun i -> keep distances.(i)) (List.init (Array.length vertices) Fun.id)
  in
  match holding s (those (fun d -> Z.leq (Z.mul d d) reach2)) with
  | Some f -> f
  | None -> (
      let least = Array.fold_left Z.min distances.(0) distances in
      match holding s (those (Z.equal least)) with
      | Some f -> f
      | None -> Scc_base.Bug.fail __POS__ "a supporting plane holds no feature")

(* Two vectors of the plane across n, orthogonal, right-handed with n. *)
let axes (n : Ivec.t) =
  let other = if Z.sign n.x = 0 && Z.sign n.y = 0 then Ivec.of_ints 1 0 0 else Ivec.of_ints 0 0 1 in
  let u = Ivec.primitive (Ivec.cross other n) in
  (u, Ivec.primitive (Ivec.cross n u))

(* The product with u and v takes space to the plane; what is left out is the part along n. *)
let project u v (p : Ivec.t) = { Flat.x = Ivec.dot u p; y = Ivec.dot v p }

(* The point of the plane n.x = height with given products with u and v, over [denominator]. *)
let lift (n, height) u v denominator (p : Flat.point) =
  let along axis amount =
    Vec.scale (Rat.div amount (Rat.make (Ivec.dot axis axis) Z.one)) (Ivec.to_vec axis)
  in
  let over c = Rat.make c denominator in
  Vec.add (along n height) (Vec.add (along u (over p.x)) (along v (over p.y)))

let shapes (s : Solid.t) project vertices f =
  let shape f = Flat.hull (List.map (fun i -> project vertices.(i)) (Solid.corners s f)) in
  List.map (fun f -> (f, shape f)) (Polyhedron.closure s.polyhedron [ f ])

(* The pair whose relative interiors hold that of the region is the one whose intersection has its dimension
   (reading I-4). A face may be seen edge-on when the resolution is coarse; of several pairs, the last is taken
   then. *)
let highest_of pairs =
  let higher best (p : Contact.pair) =
    match best with
    | Some (b : Contact.pair) when b.dimension > p.dimension -> best
    | Some _ | None -> Some p
  in
  match List.fold_left higher None pairs with
  | Some p -> p
  | None -> Scc_base.Bug.fail __POS__ "the projections of two contact features do not meet"

(* A contact feature may have vertices that are not within the resolution of the plane, when it is long and others
   of its vertices are: what is far apart does not touch. *)
let near ~resolution a b (p : Contact.pair) =
  within ~resolution:(Rat.mul (Rat.of_int 2) resolution) (Placed.corners a p.first) (Placed.corners b p.second)

let apart ~resolution (a : Placed.t) (b : Placed.t) (va, vb, denominator) gap =
  let n = Ivec.primitive (fst (Ivec.of_vec gap)) in
  let extreme choose points =
    Array.fold_left (fun m p -> choose m (Ivec.dot n p)) (Ivec.dot n points.(0)) points
  in
  let sum = Z.add (extreme Z.max va) (extreme Z.min vb) in
  let height = Rat.make sum (Z.shift_left denominator 1) in
  let reach = Rat.mul resolution (Rat.make (Z.shift_left denominator 1) Z.one) in
  let reach2 = Rat.floor (Rat.mul (Rat.mul reach reach) (Rat.make (Ivec.dot n n) Z.one)) in
  let fa = contact_feature a.solid n va ~sum ~reach2 and fb = contact_feature b.solid n vb ~sum ~reach2 in
  let u, v = axes n in
  let of_a = shapes a.solid (project u v) va fa and of_b = shapes b.solid (project u v) vb fb in
  let pairs = Contact.pairs of_a of_b in
  let highest = highest_of pairs in
  let pairs = List.filter (near ~resolution a b) pairs in
  let side f shapes =
    let _, shape = List.find (fun (g, _) -> Feature.equal f g) shapes in
    (shape, List.map (lift (n, height) u v denominator) (Flat.corners shape))
  in
  let normal = Ivec.to_vec n in
  let corners = Flat.region ~normal (side highest.first of_a) (side highest.second of_b) in
  { first = a; second = b; gap; normals = [ n ]; corners; pairs; highest; plane = (n, height) }

let find ~resolution (a : Placed.t) (b : Placed.t) =
  let ((va, vb, denominator) as vertices) = Placed.over_one a b in
  let gap = Closest.vector_over denominator va vb in
  if Vec.is_zero gap then Some (touching a b)
  else if in_resolution ~resolution gap then Some (apart ~resolution a b vertices gap)
  else None
