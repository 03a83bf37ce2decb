open Scc_exact
open Scc_geometry

type snapped = { set : Polyhedron.ifs; moved : Rat.t array; turned_over : bool; bits : int }

type refusal =
  | Not_a_surface of Polyhedron_fault.t list
  | Not_of_a_solid
  | Too_far of { vertex : int; distance : Rat.t }
  | Not_found of Polyhedron_fault.t list
  | Too_large

(* {1 What snapping cannot mend} *)

let of_structure : Polyhedron_fault.t -> bool = function
  | No_faces | Bad_vertex_index _ | Short_face _ | Open_edge _ | Repeated_edge _ | Turned_face _ | Same_position _
  | Unused_vertex _ | Separate_solids _ | Flat _ | Self_crossing (_, Some _) -> true
  | Off_plane _ | Degenerate_face _ | Self_crossing (_, None) | Not_convex _ | Coplanar_neighbours _ | In_plane _
  | Inward -> false

(* The surface of a convex polyhedron is a sphere, and three faces or more meet at each corner. *)
let may_bound_a_solid vertices faces =
  let edges = Array.fold_left (fun n c -> n + Array.length c) 0 faces / 2 in
  let degree = Array.make vertices 0 in
  Array.iter (Array.iter (fun v -> degree.(v) <- degree.(v) + 1)) faces;
  vertices - edges + Array.length faces = 2
  && Array.for_all (fun d -> d >= 3) degree
  && List.length (Surface.pieces (Surface.make vertices faces)) = 1

(* {1 A frame in which the solid is about as long as wide and high, around the origin} *)

type frame = { centre : Vec.t; exponent : int array }

let components (v : Vec.t) = [| v.x; v.y; v.z |]
let vector a = Vec.make a.(0) a.(1) a.(2)

(* The least k >= -1000 with length <= 2^k. *)
let exponent_above length =
  let rec up k = if Rat.compare length (Rat.power_of_two k) <= 0 then k else up (k + 1) in
  let rec down k = if k > -1000 && Rat.compare length (Rat.power_of_two (k - 1)) <= 0 then down (k - 1) else k in
  down (up 0)

let frame points =
  let count = Rat.of_int (Array.length points) in
  let axis k =
    let all = Array.map (fun p -> (components p).(k)) points in
    let low = Array.fold_left Rat.min all.(0) all and high = Array.fold_left Rat.max all.(0) all in
    let e = exponent_above (Rat.sub high low) in
    let mean = Rat.div (Array.fold_left Rat.add Rat.zero all) count in
    (* short, and well inside *)
    (Rat.round_to mean ~quantum:(Rat.power_of_two (e - 6)), e)
  in
  let axes = Array.init 3 axis in
  { centre = vector (Array.map fst axes); exponent = Array.map snd axes }

let inward frame p =
  Array.mapi (fun k x -> Rat.mul x (Rat.power_of_two (-frame.exponent.(k)))) (components (Vec.sub p frame.centre))

let outward frame v =
  let grown k x = Rat.mul x (Rat.power_of_two frame.exponent.(k)) in
  Vec.add frame.centre (vector (Array.mapi grown (components v)))

(* {1 Search} *)

let volume_sign points faces =
  let six corners =
    let p k = points.(corners.(k)) in
    let sum = ref Rat.zero in
    for k = 1 to Array.length corners - 2 do
      sum := Rat.add !sum (Vec.dot (p 0) (Vec.cross (p k) (p (k + 1))))
    done;
    !sum
  in
  Rat.sign (Array.fold_left (fun s c -> Rat.add s (six c)) Rat.zero faces)

let reversed a =
  let n = Array.length a in
  Array.init n (fun i -> a.(n - 1 - i))

let distance2 a b = Vec.norm2 (Vec.sub a b)
let grids = List.init 21 (fun k -> 8 + (2 * k))
let orders = 3

(* Numbers that are estimated to get longer are not worth having. *)
let most_bits = 2_000

(* The frame makes lengths along an axis others, so that vertices are as easy to move in it. *)
let ease frame =
  let least = Array.fold_left Int.min frame.exponent.(0) frame.exponent in
  Array.map (fun e -> ldexp 1. (2 * Int.max (-50) (least - e))) frame.exponent

type attempt = Near of Polyhedron.ifs | Unfit of Polyhedron_fault.t list | Far

let attempt frame (set : Polyhedron.ifs) ~tolerance2 order grid guess =
  let count = Array.length set.ifs_vertices in
  let place e = outward frame (Placing.vector e) in
  let keep u e = u >= count || Rat.compare (distance2 (place e) (snd set.ifs_vertices.(u))) tolerance2 <= 0 in
  match Placing.place order ~grid guess ~keep with
  | None -> Far
  | Some elements -> (
      let placed v (name, _) = (name, place elements.(v)) in
      let moved = { set with ifs_vertices = Array.mapi placed set.ifs_vertices } in
      if Polyhedron.too_fine moved then Far
      else match Polyhedron.of_ifs moved with Ok _ -> Near moved | Error faults -> Unfit faults)

let longest (set : Polyhedron.ifs) =
  Array.fold_left (fun b (_, v) -> Int.max b (Vec.bits v)) 0 set.ifs_vertices

let distances (a : Polyhedron.ifs) (b : Polyhedron.ifs) =
  let root (q : Rat.t) = if Rat.sign q = 0 then Rat.zero else Rat.sqrt_above (Q.num q) (Q.den q) in
  Array.map2 (fun (_, p) (_, q) -> root (distance2 p q)) a.ifs_vertices b.ifs_vertices

let farthest moved =
  let best = ref 0 in
  Array.iteri (fun v d -> if Rat.compare d moved.(!best) > 0 then best := v) moved;
  !best

(* Where vertices are before they are placed. *)
let polished frame (set : Polyhedron.ifs) (t : Polish.t) =
  let at v = outward frame (vector (Array.init 3 (fun k -> Q.of_float t.points.((3 * v) + k)))) in
  { set with ifs_vertices = Array.mapi (fun v (n, _) -> (n, at v)) set.ifs_vertices }

(* A vertex of a neighbour that is in front of a face by more than rounding errs: no grid mends that. *)
let in_front (i : Incidence.t) (t : Polish.t) =
  let height f v =
    let n k = t.planes.((3 * f) + k) and p k = t.points.((3 * v) + k) in
    (n 0 *. p 0) +. (n 1 *. p 1) +. (n 2 *. p 2) -. 1.
  in
  let of_face f corners =
    let on u = Array.to_list i.neighbours.(u) in
    let faces = List.sort_uniq Int.compare (List.concat_map on (Array.to_list corners)) in
    let others = List.concat_map on faces in
    let strange v = not (Array.exists (Int.equal v) corners) in
    List.find_opt (fun v -> strange v && height f v > 1e-9) (List.sort_uniq Int.compare others)
    |> Option.map (fun v -> Polyhedron_fault.Not_convex (f, v))
  in
  List.find_map Fun.id (Array.to_list (Array.mapi of_face i.faces))

let search ~tolerance ~turned_over (set : Polyhedron.ifs) =
  let points = Array.map snd set.ifs_vertices in
  let frame = frame points in
  let incidence = Incidence.make ~vertices:(Array.length points) (Array.map snd set.ifs_faces) in
  let floats = Array.concat (List.map (fun p -> Array.map Rat.to_float (inward frame p)) (Array.to_list points)) in
  match Polish.polish incidence ~ease:(ease frame) floats with
  | Error Too_large -> Error Too_large
  | Error Inside_out -> Error Not_of_a_solid
  | Ok t -> (
      let guess u =
        let a, k = if u < incidence.vertices then (t.points, u) else (t.planes, u - incidence.vertices) in
        Array.sub a (3 * k) 3
      in
      let tolerance2 = Rat.mul tolerance tolerance in
      let fault = in_front incidence t in
      let short (o : Order.t) = fst o.cost <= most_bits in
      let ordered = if Option.is_none fault then Order.best incidence ~grid:20 ~count:orders else [] in
      let candidates = List.filter short ordered in
      let rec go faults = function
        | [] -> Error faults
        | (grid, order) :: rest -> (
            match attempt frame set ~tolerance2 order grid guess with
            | Near found ->
              Ok { set = found; moved = distances set found; turned_over; bits = longest found }
            | Unfit faults -> go faults rest
            | Far -> go faults rest)
      in
      let all = List.concat_map (fun grid -> List.map (fun order -> (grid, order)) candidates) grids in
      match go (Option.to_list fault) all with
      | Ok _ as found -> found
      | Error faults ->
        let moved = distances set (polished frame set t) in
        let vertex = farthest moved in
        if (match (ordered, candidates) with _ :: _, [] -> true | _ -> false) then Error Too_large
        else if Rat.compare moved.(vertex) tolerance > 0 then
          Error (Too_far { vertex; distance = moved.(vertex) })
        else Error (Not_found faults))

let finite frame = Array.for_all (fun e -> e > -300 && e < 300) frame.exponent

let snap ~tolerance (set : Polyhedron.ifs) =
  match Polyhedron.of_ifs set with
  | Ok _ ->
    let moved = Array.map (fun _ -> Rat.zero) set.ifs_vertices in
    Ok { set; moved; turned_over = false; bits = longest set }
  | Error faults -> (
      match List.filter of_structure faults with
      | _ :: _ as bad -> Error (Not_a_surface bad)
      | [] ->
        let faces = Array.map snd set.ifs_faces and points = Array.map snd set.ifs_vertices in
        let count = Array.length points in
        if not (may_bound_a_solid count faces) then Error Not_of_a_solid
        else if not (finite (frame points)) then Error Too_large
        else
          let turned_over = volume_sign points faces < 0 in
          let outside (n, c) = (n, if turned_over then reversed c else c) in
          search ~tolerance ~turned_over { set with ifs_faces = Array.map outside set.ifs_faces })

(* {1 In words} *)

let decimal = Decimal.significant ~digits:3

let explain (set : Polyhedron.ifs) ~tolerance refusal =
  let vertex i = fst set.ifs_vertices.(i) and face i = fst set.ifs_faces.(i) in
  let first = function
    | [] -> ("", None)
    | fault :: _ ->
      (": " ^ Polyhedron_fault.message ~vertex ~face fault, Polyhedron_fault.hint ~vertex ~face fault)
  in
  match refusal with
  | Not_a_surface faults ->
    let why, hint = first faults in
    ("no small move of its vertices mends it" ^ why, hint)
  | Not_of_a_solid ->
    ( "its faces are not those of a convex solid, which all look outwards, three or more of them at each vertex",
      Some "a solid with triangles in one plane needs them merged into one face" )
  | Too_far { vertex = v; distance } ->
    ( Printf.sprintf "there is no convex solid within %s, as far as is known: the nearest has %s %s away"
        (decimal tolerance) (vertex v) (decimal distance),
      Some (Printf.sprintf "a distance somewhat above %s might do" (decimal distance)) )
  | Not_found faults ->
    let why, hint = first faults in
    (Printf.sprintf "no convex solid is found within %s%s" (decimal tolerance) why, hint)
  | Too_large ->
    ( "it has so many faces with more than three corners that exact coordinates are too long",
      Some "scc shape --hull takes the hull of its vertices, which stay as they are: most faces become triangles" )
