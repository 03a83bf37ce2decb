open Scc_exact
open Scc_geometry
open Scc_calculus
open Scc_rigid

type t = { first : int; second : int; parts : ((int * int) * (int * int)) list }

(* {1 Parts} *)

type part = {
  process : int;
  leaf : State.leaf;
  index : int;
  centre : Vec.t;  (* of its process *)
  reach : Rat.t;  (* from there *)
  state : State.process;
}

let parts (m : Model.t) (s : State.t) =
  let of_process process (state : State.process) =
    let centre = State.centre_of_mass m state in
    let of_leaf (leaf : State.leaf) =
      List.init (Array.length m.leaves.(leaf.leaf).parts) (fun index ->
          { process; leaf; index; centre; reach = Turn.reach m ~centre leaf index; state })
    in
    List.concat_map of_leaf (Array.to_list state.leaves)
  in
  Array.to_list s.processes |> List.mapi of_process |> List.concat |> Array.of_list

let motion m p = Turn.motion m p.state ~centre:p.centre p.leaf p.index
let placed m p = State.placed m p.leaf p.index
let name p = (p.leaf.leaf, p.index)

let in_relative_motion a b =
  a.process <> b.process
  && (Turn.spinning a.state || Turn.spinning b.state
      || not (Vec.equal a.state.velocity b.state.velocity))

(* {1 Neighbours}

   A box that holds a part during [0, span] and all that is within a margin of it: that of the solid where it has
   not turned and does not, else of the ball that it turns in. *)

let upright (m : Model.t) p =
  let box = m.leaves.(p.leaf.leaf).parts.(p.index).solid.box in
  let corner bound = (bound box 0, bound box 1, bound box 2) in
  let exact (x, y, z) =
    if Float.is_finite x && Float.is_finite y && Float.is_finite z then
      Some (Vec.add (State.part_position m p.leaf p.index) (Vec.make (Q.of_float x) (Q.of_float y) (Q.of_float z)))
    else None
  in
  if Quaternion.is_identity p.leaf.turned && not (Turn.spinning p.state) then
    match (exact (corner Float_box.low), exact (corner Float_box.high)) with
    | Some low, Some high -> Some (low, high)
    | None, _ | _, None -> None
  else None

let box (m : Model.t) ~span ~margin p =
  let ball () =
    let r = Vec.make p.reach p.reach p.reach in
    (Vec.sub p.centre r, Vec.add p.centre r)
  in
  let low, high = match upright m p with Some ends -> ends | None -> ball () in
  let way = Vec.scale span p.state.velocity in
  let least (a : Vec.t) (b : Vec.t) = Vec.make (Rat.min a.x b.x) (Rat.min a.y b.y) (Rat.min a.z b.z) in
  let most (a : Vec.t) (b : Vec.t) = Vec.make (Rat.max a.x b.x) (Rat.max a.y b.y) (Rat.max a.z b.z) in
  let margin = Vec.make margin margin margin in
  Float_box.of_corners
    (Vec.sub (least low (Vec.add low way)) margin)
    (Vec.add (most high (Vec.add high way)) margin)

let near m ~span ~margin parts =
  Boxes.pairs (Array.map (box m ~span ~margin) parts)
  |> List.map (fun (i, j) -> (parts.(i), parts.(j)))
  |> List.filter (fun (a, b) -> in_relative_motion a b)

(* {1 Rule Ftoc} *)

let grid m a b = Cast.grid (motion m a) (motion m b) ~resolution:(Turn.rigid m).resolution
let cell k = Rat.make Z.one (Z.shift_left Z.one k)

let cast m a b ~span ~grid =
  match Cast.first_time_of_contact (motion m a) (motion m b) ~span ~grid with
  | Never -> None
  | At t -> Some t
  | Inside -> Scc_base.Bug.fail __POS__ "two bodies interpenetrate"

let collide m (a, b) =
  let grid = grid m a b in
  Option.is_some (cast m a b ~span:(cell grid) ~grid)

let within_resolution m parts = near m ~span:Rat.zero ~margin:(Turn.rigid m).resolution parts

let colliding m s =
  let found = List.filter (collide m) (within_resolution m (parts m s)) in
  let compare (a, b) (c, d) =
    let c1 = Int.compare a.process c.process in
    if c1 <> 0 then c1 else Int.compare b.process d.process
  in
  let group done_ (a, b) =
    let pair = (name a, name b) in
    match done_ with
    | c :: rest when c.first = a.process && c.second = b.process -> { c with parts = pair :: c.parts } :: rest
    | _ -> { first = a.process; second = b.process; parts = [ pair ] } :: done_
  in
  List.stable_sort compare found |> List.fold_left group []
  |> List.rev_map (fun c -> { c with parts = List.rev c.parts })

(* When nothing spins, two bodies that meet at all do so at a time that is found on straight lines. *)
let straight m a b =
  let solid p = Placed.fixed_solid (placed m p) in
  let obstacle = Obstacle.make (solid a) (solid b) in
  let at p = State.part_position m p.leaf p.index in
  let w = Vec.sub b.state.velocity a.state.velocity in
  match Obstacle.first_time_of_contact obstacle (Vec.sub (at b) (at a)) w with
  | Never -> None
  | At t -> Some t
  | Inside -> Scc_base.Bug.fail __POS__ "two bodies interpenetrate"

(* {1 Rule Quiescent} *)

let cube =
  let vertex i =
    let side bit = if i land bit = 0 then -1 else 1 in
    (Printf.sprintf "v%d" i, Vec.of_ints (side 1) (side 2) (side 4))
  in
  let faces =
    [ [ 0; 2; 3; 1 ]; [ 4; 5; 7; 6 ]; [ 0; 4; 6; 2 ]; [ 1; 3; 7; 5 ]; [ 0; 1; 5; 4 ]; [ 2; 6; 7; 3 ] ]
  in
  let face i corners = (Printf.sprintf "f%d" i, Array.of_list corners) in
  let set =
    {
      Polyhedron.ifs_vertices = Array.init 8 vertex;
      ifs_faces = Array.of_list (List.mapi face faces);
    }
  in
  match Polyhedron.of_ifs set with
  | Ok cube -> cube
  | Error _ -> Scc_base.Bug.fail __POS__ "a cube is no convex polyhedron"

(* A solid that only moves in a straight line and never leaves a part outside: the part itself if it does not spin,
   else a cube about the ball that it turns in, with room for more than the resolution. *)
let hull m p =
  if Turn.spinning p.state then
    let room = Rat.add p.reach (Rat.mul (Rat.of_int 2) (Turn.rigid m).resolution) in
    (Solid.make ~id:0 cube (Mat.scale room Mat.identity), p.centre)
  else (Placed.fixed_solid (placed m p), State.part_position m p.leaf p.index)

let never_meet m (a, b) =
  let solid_a, at_a = hull m a and solid_b, at_b = hull m b in
  let w = Vec.sub b.state.velocity a.state.velocity in
  match Obstacle.first_time_of_contact (Obstacle.make solid_a solid_b) (Vec.sub at_b at_a) w with
  | Never -> true
  | At _ | Inside -> false

let least a b = match (a, b) with None, x | x, None -> x | Some s, Some t -> Some (Rat.min s t)

let all_pairs parts =
  let all = Array.to_list parts in
  List.concat_map (fun a -> List.filter_map (fun b ->
      if a.process < b.process && in_relative_motion a b then Some (a, b) else None) all) all

let none_ahead m s = List.for_all (never_meet m) (all_pairs (parts m s))

let first_time_of_contact m s ~limit =
  let parts = parts m s in
  let until span =
    let earlier best (a, b) =
      let grid = grid m a b in
      (* what would be earlier than the best begins to interpenetrate before this *)
      let span = match best with None -> span | Some t -> Rat.min span (Rat.add t (cell grid)) in
      least best (cast m a b ~span ~grid)
    in
    List.fold_left earlier None (near m ~span ~margin:Rat.zero parts)
  in
  match limit with
  | Some span -> until span
  | None ->
    let meets = List.fold_left (fun best (a, b) -> least best (straight m a b)) None (all_pairs parts) in
    Option.bind meets (fun t -> until (Rat.add t Rat.one))

(* {1 Rules Bind and Bounce} *)

let find parts (leaf, index) =
  match List.find_opt (fun p -> p.leaf.leaf = leaf && p.index = index) (Array.to_list parts) with
  | Some p -> p
  | None -> Scc_base.Bug.fail __POS__ "a part that is not there"

let contact m a b = Near_contact.find ~resolution:(Turn.rigid m).resolution (placed m a) (placed m b)

let touching m a b =
  match contact m a b with
  | Some c -> c.pairs
  | None -> Scc_base.Bug.fail __POS__ "two bodies collide from afar"

let bind m (s : State.t) parts e =
  let p = s.processes.(e.first) and q = s.processes.(e.second) in
  let whole = Impact.bind [ Turn.mover m p; Turn.mover m q ] in
  let join (candidate : Binding.candidate) =
    {
      Collision.label = Transition.Bind candidate.bond;
      rules = Rule.Bind :: candidate.used;
      results = [ Turn.moving m whole (Binding.joined m p q candidate) ];
    }
  in
  let candidates (one, two) =
    let a = find parts one and b = find parts two in
    Binding.candidates m p q ~one ~two (fun () -> touching m a b)
  in
  List.map join (List.concat_map candidates e.parts)

let bounce m (s : State.t) parts e =
  let p = s.processes.(e.first) and q = s.processes.(e.second) in
  let pairs =
    List.filter (fun (a, b) -> a.process = e.first && b.process = e.second) (within_resolution m parts)
  in
  let contacts = List.filter_map (fun (a, b) -> contact m a b) pairs in
  match Impact.bounce (Turn.mover m p) (Turn.mover m q) contacts with
  | Persistent -> Error (Transition.Persistent_contact (p.leaves.(0).leaf, q.leaves.(0).leaf))
  | Bounced (first, second) ->
    let moved mover r = Process.restart_clock m (Turn.moving m mover r) in
    Ok
      {
        Collision.label = Transition.Bounce (p.leaves.(0).leaf, q.leaves.(0).leaf);
        rules = [ Rule.Bounce ];
        results = [ moved first p; moved second q ];
      }

let outcomes m s e =
  let parts = parts m s in
  match bind m s parts e with
  | [] -> Result.map (fun o -> [ o ]) (bounce m s parts e)
  | outcomes -> Ok outcomes

(* {1 Room} *)

let apart m s process ~by =
  let parts = parts m s in
  let boxes = Array.map (box m ~span:Rat.zero ~margin:by) parts in
  let far a b =
    let vertices p = Placed.vertices (placed m p) in
    Rat.compare (Closest.distance2 (vertices a) (vertices b)) (Rat.mul by by) > 0
  in
  let ok = ref true in
  Array.iteri (fun i a ->
      if a.process = process then
        Array.iteri (fun j b ->
            if !ok && b.process <> process && Float_box.meet boxes.(i) boxes.(j) && not (far a b) then ok := false)
          parts)
    parts;
  !ok
