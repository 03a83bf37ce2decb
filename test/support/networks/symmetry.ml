open Scc_exact
open Scc_geometry
open Scc_calculus
open Scc_semantics

type t = {
  name : string;
  model : Model.t -> Model.t;
  state : State.t -> State.t;
  later : Rat.t -> State.t -> State.t;
  duration : Rat.t -> Rat.t;
  impulse : Rat.t -> Rat.t;
  velocity : Vec.t -> Vec.t;
  bond : State.bond -> State.bond;
  leaf : int -> int;
}

let make name ?(model = Fun.id) ?later ?(duration = Fun.id) ?(impulse = Fun.id) ?(velocity = Fun.id)
    ?(bond = Fun.id)    ?(leaf = Fun.id) state =
  let later = match later with Some f -> f | None -> fun _ -> state in
  { name; model; state; later; duration; impulse; velocity; bond; leaf }

let mapped_given map (g : Given.t) = { Given.velocity = map g.velocity; spin = Option.map map g.spin }

let mapped_draw velocity : State.draw -> State.draw = function
  | Waits -> Waits
  | Drawn given -> Drawn (mapped_given velocity given)

let mapped_lots ?(time = Fun.id) ?(bond = Fun.id) ?(leaf = Fun.id) ?(summand = Fun.id)
    (lots : State.lots) : State.lots =
  let drawn list =
    List.sort (fun (i, _) (j, _) -> Int.compare i j) (List.map (fun (l, s) -> (leaf l, summand s)) list)
  in
  let lot : State.lot -> State.lot = function
    | Undecided -> Undecided
    | Let_go d -> Let_go (drawn d)
    | Next d -> Next (drawn d)
  in
  let pending = List.map (fun (b, l) -> (bond b, lot l)) lots.pending in
  { since = time lots.since; pending = List.sort (fun (b, _) (c, _) -> State.compare_bond b c) pending }

let map_processes f (s : State.t) =
  State.make ~processes:(List.map f (Array.to_list s.processes)) ~step:s.step ~time:s.time

(* Moves every position by one map, every velocity and spin by another, and every orientation by a third. *)
let move ~position ~velocity ~turned =
  map_processes (fun (p : State.process) ->
      let leaf (l : State.leaf) = { l with position = position l.position; turned = turned l.turned } in
      State.process ?phase:p.phase ?draw:(Option.map (mapped_draw velocity) p.draw) ?lots:p.lots
        ~leaves:(List.map leaf (Array.to_list p.leaves))
        ~bonds:(Array.to_list p.bonds) ~velocity:(velocity p.velocity) ~spin:(velocity p.spin) ~since:p.since
        ~lasts:p.lasts ~kept:(velocity p.kept) ~clock:p.clock ())

let translation by =
  make ("translation by " ^ Vec.to_string by)
    (move ~position:(Vec.add by) ~velocity:Fun.id ~turned:Fun.id)

let turned_model r (m : Model.t) =
  let part (p : Model.part) =
    let solid = Solid.make ~id:p.solid.id p.solid.polyhedron (Mat.mul r p.solid.linear) in
    { p with solid; offset = Mat.apply r p.offset }
  in
  let leaf (l : Model.leaf) = { l with parts = Array.map part l.parts } in
  { m with leaves = Array.map leaf m.leaves }

(* A rotation of a cube as a quaternion. *)
let quaternion_of r =
  let digits = List.map Z.of_int [ 0; 1; -1 ] in
  let all = List.concat_map (fun x -> List.map (fun y -> (x, y)) digits) digits in
  let is_it ((w, x), (y, z)) =
    if List.for_all (fun c -> Z.sign c = 0) [ w; x; y; z ] then None
    else
      let q = Quaternion.make w x y z in
      if Mat.equal (Quaternion.to_mat q) r then Some q else None
  in
  match List.find_map is_it (List.concat_map (fun a -> List.map (fun b -> (a, b)) all) all) with
  | Some q -> q
  | None -> failwith "not a rotation of a cube"

(* The shapes are turned as declared; how they have turned since then is seen from elsewhere. *)
let seen_by name q r =
  let turned t = Quaternion.mul q (Quaternion.mul t (Quaternion.inverse q)) in
  let apply = Mat.apply r in
  make name ~model:(turned_model r) ~velocity:apply (move ~position:apply ~velocity:apply ~turned)

let rotation name r = seen_by name (quaternion_of r) r
let any_rotation q = seen_by ("rotation by " ^ Quaternion.to_string q) q (Quaternion.to_mat q)

let turning q =
  let apply = Quaternion.apply q in
  let state = move ~position:apply ~velocity:apply ~turned:(Quaternion.mul q) in
  make ("turning by " ^ Quaternion.to_string q) ~velocity:apply state

(* The signed permutation matrices of determinant 1. *)
let rotations =
  let axes = [ (1, 0, 0); (0, 1, 0); (0, 0, 1); (-1, 0, 0); (0, -1, 0); (0, 0, -1) ] in
  let vec (x, y, z) = Vec.of_ints x y z in
  let orthogonal a b = Rat.sign (Vec.dot a b) = 0 in
  List.concat_map
    (fun a ->
       List.filter_map
         (fun b ->
            let a = vec a and b = vec b in
            if orthogonal a b then
              let r = Mat.make a b (Vec.cross a b) in
              let name = Printf.sprintf "rotation %s, %s" (Vec.to_string a) (Vec.to_string b) in
              Some (rotation name r)
            else None)
         axes)
    axes

let permutation perm =
  let finish (f : State.finish) = { f with at = perm.(f.at) } in
  let bond (b : State.bond) = State.bond b.name (finish b.one) (finish b.two) in
  let model (m : Model.t) =
    let leaves = Array.copy m.leaves in
    Array.iteri (fun i l -> leaves.(perm.(i)) <- l) m.leaves;
    { m with leaves }
  in
  let process (p : State.process) =
    let leaf (l : State.leaf) = { l with leaf = perm.(l.leaf) } in
    State.process ?phase:p.phase ?draw:p.draw
      ?lots:(Option.map (mapped_lots ~bond ~leaf:(Array.get perm)) p.lots)
      ~leaves:(List.map leaf (Array.to_list p.leaves))
      ~bonds:(List.map bond (Array.to_list p.bonds))
      ~velocity:p.velocity ~spin:p.spin ~since:p.since ~lasts:p.lasts ~kept:p.kept ~clock:p.clock ()
  in
  let name =
    "order " ^ String.concat ", " (List.map string_of_int (Array.to_list perm))
  in
  make name ~model ~bond ~leaf:(Array.get perm) (map_processes process)

let boost by =
  let velocity = Vec.add by in
  let boosted (p : State.process) =
    State.with_velocity (velocity p.velocity) (State.with_draw (Option.map (mapped_draw velocity) p.draw) p)
  in
  let state = map_processes boosted in
  let later d s =
    let leaf (l : State.leaf) = { l with position = Vec.axpy d by l.position } in
    map_processes (State.map_leaves leaf) (state s)
  in
  make ("boost by " ^ Vec.to_string by) ~velocity ~later state

(* {1 Units}

   A length of 1 becomes [length], a time of 1 [time] and a mass of 1 [mass]; all else follows. *)

(* The probability within a step stays what it is, as steps are scaled too. *)
let scaled_odds ~time : Odds.t -> Odds.t = function
  | (Chance _ | Open_chance _) as q -> q
  | Rate { rate; alone } -> Rate { rate = Rat.div rate time; alone }

let rec behaving ~time ~impulse (b : Behaviour.t) =
  let again = behaving ~time ~impulse and push = Rat.mul impulse in
  match b with
  | Nil | Call _ -> b
  | Open (polarity, c, b) -> Behaviour.open_ polarity c (again b)
  | Weak (c, j, b) -> Behaviour.weak ~push:(push j.push) ?odds:(Option.map (scaled_odds ~time) j.odds) c (again b)
  | Strong (l, j, b) -> Behaviour.strong ~push:(push j) l (again b)
  | Delay (t, b) -> Behaviour.delay (Rat.mul time t) (again b)
  | Wait (t, b) -> Behaviour.wait (Scc_polyhedra.Linear.scale time t) (again b)
  | Sum (b, c) -> Behaviour.sum (again b) (again c)

let impulse ~length ~time ~mass = Rat.mul mass (Rat.div length time)

let scaled_model ~length ~time ~mass (m : Model.t) =
  let behaving = behaving ~time ~impulse:(impulse ~length ~time ~mass) in
  let part (p : Model.part) =
    let solid = Solid.make ~id:p.solid.id p.solid.polyhedron (Mat.scale length p.solid.linear) in
    { p with solid; offset = Vec.scale length p.offset; mass = Rat.mul mass p.mass }
  in
  let leaf (l : Model.leaf) = { l with parts = Array.map part l.parts; mass = Rat.mul mass l.mass } in
  let rigid (r : Model.rigid) = { r with resolution = Rat.mul length r.resolution } in
  {
    m with
    leaves = Array.map leaf m.leaves;
    definitions =
      Array.map (fun (d : Behaviour.definition) -> { d with body = behaving d.body }) m.definitions;
    timestep = Rat.mul time m.timestep;
    splits = (match m.splits with Every step -> Every (Rat.mul time step) | Any_time -> Any_time);
    rigid = Option.map rigid m.rigid;
  }

let scaling ~length ~time ~mass =
  let speed = Vec.scale (Rat.div length time) and spin = Vec.scale (Rat.div Rat.one time) in
  let momentum = Vec.scale (Rat.div (Rat.mul mass (Rat.mul length length)) time) in
  let leaf (l : State.leaf) =
    let term = behaving ~time ~impulse:(impulse ~length ~time ~mass) l.behaviour.term in
    let behaviour = Behaviour.aged l.behaviour.origin term in
    { l with position = Vec.scale length l.position; behaviour }
  in
  let process (p : State.process) =
    let summand = behaving ~time ~impulse:(impulse ~length ~time ~mass) in
    State.process ?phase:p.phase ?draw:(Option.map (mapped_draw speed) p.draw)
      ?lots:(Option.map (mapped_lots ~time:(Rat.mul time) ~summand) p.lots)
      ~leaves:(List.map leaf (Array.to_list p.leaves))
      ~bonds:(Array.to_list p.bonds) ~velocity:(speed p.velocity) ~spin:(spin p.spin) ~since:(Rat.mul time p.since)
      ~lasts:(Option.map (Rat.mul time) p.lasts) ~kept:(momentum p.kept)
      ~clock:(Option.map (Rat.mul time) p.clock) ()
  in
  let step (s : State.step) = { s with State.remaining = Rat.mul time s.remaining } in
  let state (s : State.t) =
    State.make
      ~processes:(List.map process (Array.to_list s.processes))
      ~step:(Option.map step s.step)
      ~time:(Option.map (Rat.mul time) s.time)
  in
  let say = Rat.to_string in
  make
    (Printf.sprintf "lengths times %s, times times %s, masses times %s" (say length) (say time) (say mass))
    ~model:(scaled_model ~length ~time ~mass) ~duration:(Rat.mul time)
    ~impulse:(Rat.mul (impulse ~length ~time ~mass)) ~velocity:speed state

(* {1 Transitions under a symmetry} *)

(* A bounce is named by the first leaves of the two processes, which need not be first afterwards. *)
let first_leaf symmetry (s : State.t) leaf =
  Array.fold_left
    (fun least (l : State.leaf) -> min least (symmetry.leaf l.leaf))
    max_int (Option.get (State.home s leaf)).leaves

let map_release symmetry ({ bond; push } : Transition.release) : Transition.release =
  { bond = symmetry.bond bond; push = symmetry.impulse push }

let map_releases symmetry releases =
  let in_order (r : Transition.release) (s : Transition.release) = State.compare_bond r.bond s.bond in
  List.sort in_order (List.map (map_release symmetry) releases)

let map_label symmetry s : Transition.label -> Transition.label = function
  | Time d -> Time (symmetry.duration d)
  | Bind b -> Bind (symmetry.bond b)
  | Close b -> Close (symmetry.bond b)
  | Weak_split releases -> Weak_split (map_releases symmetry releases)
  | Strong_split releases -> Strong_split (map_releases symmetry releases)
  | Lot l -> Lot { l with bond = symmetry.bond l.bond }
  | Draw { first; given; chance } ->
    Draw { first = first_leaf symmetry s first; given = mapped_given symmetry.velocity given; chance }
  | Absorb { first; absorber } ->
    Absorb { first = first_leaf symmetry s first; absorber = symmetry.leaf absorber }
  | Bounce { firsts; hits } ->
    let part (leaf, index) = (symmetry.leaf leaf, index) in
    let hit (h : Transition.hit) = Transition.hit (part h.one) (part h.two) in
    Bounce
      {
        firsts = List.sort Int.compare (List.map (first_leaf symmetry s) firsts);
        hits = List.sort Transition.compare_hit (List.map hit hits);
      }

let map_transition symmetry s (t : Transition.t) =
  { t with label = map_label symmetry s t.label; target = symmetry.later (Transition.duration t) t.target }

let same_rules a b = List.length a = List.length b && List.for_all2 ( == ) a b

(* A symmetry may cut bodies into parts: of who touches, the leaves count. *)
let of_leaves : Transition.label -> Transition.label = function
  | Bounce { firsts; hits } ->
    let hit (h : Transition.hit) = Transition.hit (fst h.one, 0) (fst h.two, 0) in
    Bounce { firsts; hits = List.sort_uniq Transition.compare_hit (List.map hit hits) }
  | (Time _ | Bind _ | Close _ | Absorb _ | Weak_split _ | Strong_split _ | Draw _ | Lot _) as label -> label

let equal (a : Transition.t) (b : Transition.t) =
  Transition.equal_label (of_leaves a.label) (of_leaves b.label)
  && same_rules a.rules b.rules
  && State.equal a.target b.target

(* Takes one equal element out, if there is one. *)
let rec without x = function
  | [] -> None
  | y :: rest when equal x y -> Some rest
  | y :: rest -> Option.map (fun rest -> y :: rest) (without x rest)

let rec same_multiset a b =
  match a with
  | [] -> List.compare_length_with b 0 = 0
  | x :: a -> ( match without x b with None -> false | Some b -> same_multiset a b)

let broken symmetry m states =
  let image = symmetry.model m in
  let differs (s, transitions) =
    let expected = List.map (map_transition symmetry s) transitions in
    let got = Reach.successors image (symmetry.state s) in
    if same_multiset expected got then None
    else
      let labels ts =
        String.concat "; "
          (List.map (fun (t : Transition.t) -> Transition.label_to_string image t.label) ts)
      in
      Some (Printf.sprintf "%s: expected %s; got %s" symmetry.name (labels expected) (labels got))
  in
  List.find_map differs states
