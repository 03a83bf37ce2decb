open Scc_base
open Scc_exact
open Scc_geometry
open Scc_calculus
open Scc_property

(* A coordinate of an image: one of the original, or its opposite. *)
type row = { from : Vec.axis; flipped : bool }

type map = { x : row; y : row; z : row }

type t = {
  map : map;
  shift : Vec.t;  (** after the map *)
  own : Vec.t array;  (** of each leaf that is not fixed: the map takes its shape to its shape, moved by this *)
  origin : int array;
  (** of each fixed leaf: the one that comes to where it is, or -1 if only all of them together do; of others, the
      leaf itself *)
}

let row map : Vec.axis -> row = function X -> map.x | Y -> map.y | Z -> map.z
let along r v = if r.flipped then Rat.neg (Vec.component r.from v) else Vec.component r.from v
let apply map v = Vec.make (along map.x v) (along map.y v) (along map.z v)

let maps =
  let either from = [ { from; flipped = false }; { from; flipped = true } ] in
  let signs (a, b, c) =
    List.concat_map (fun x ->
        List.concat_map (fun y -> List.map (fun z -> { x; y; z }) (either c)) (either b)) (either a)
  in
  let orders : (Vec.axis * Vec.axis * Vec.axis) list =
    [ (X, Y, Z); (X, Z, Y); (Y, X, Z); (Y, Z, X); (Z, X, Y); (Z, Y, X) ]
  in
  List.tl (List.concat_map signs orders)

(** {2 Bodies} *)

let sorted = List.sort Vec.compare
let equal_points = List.equal Vec.equal
let corners (part : Model.part) = List.init (Array.length part.solid.vertices) (Solid.vertex part.solid)

(* The corners of each part from the reference point of the leaf. *)
let parts (leaf : Model.leaf) =
  let placed (p : Model.part) = List.map (Vec.add p.offset) (corners p) in
  Array.to_list (Array.map placed leaf.parts)

let placed by points = List.map (Vec.add by) points

(* By how much the image of a shape is moved against the shape; [None] if it is another shape. *)
let moved map (leaf : Model.leaf) =
  let parts = parts leaf in
  let images = List.map (fun points -> sorted (List.map (apply map) points)) parts in
  let by = Vec.sub (List.hd (List.hd images)) (List.hd (sorted (List.hd parts))) in
  let same image part = equal_points image (placed by (sorted part)) in
  if List.for_all2 same images parts then Some by else None

type wall = { leaf : int; absorbs : bool; solids : Vec.t list list }

let compare_points = List.compare Vec.compare
let compare_solids = List.compare compare_points

let walls (m : Model.t) (initial : State.t) =
  let wall ((l : State.leaf), (leaf : Model.leaf)) =
    let solids = List.map (fun points -> sorted (placed l.position points)) (parts leaf) in
    { leaf = l.leaf; absorbs = leaf.absorbs; solids = List.sort compare_points solids }
  in
  List.map (fun (l : State.leaf) -> (l, m.leaves.(l.leaf))) (State.leaves initial)
  |> List.filter (fun (_, (leaf : Model.leaf)) -> leaf.fixed)
  |> List.map wall

let box points =
  let ends pick (a : Vec.t) (b : Vec.t) = Vec.make (pick a.x b.x) (pick a.y b.y) (pick a.z b.z) in
  let all pick = List.fold_left (ends pick) (List.hd points) (List.tl points) in
  { Boxes.low = all Rat.min; high = all Rat.max }

let image_of at w =
  let solids = List.map (fun points -> sorted (List.map at points)) w.solids in
  { w with solids = List.sort compare_points solids }

(* Of each fixed leaf, the one whose image is there. *)
let origins walls images =
  let order a b = Bool.compare a.absorbs b.absorbs <?> fun () -> compare_solids a.solids b.solids in
  let pair w i = if order w i = 0 then Some (w.leaf, i.leaf) else None in
  Option.all (fun (w, i) -> pair w i) (List.combine (List.sort order walls) (List.sort order images))

(* The boxes that a wall is made of; [None] if one of its solids is none. *)
let boxes w =
  let of_solid points =
    let b = box points in
    if equal_points (sorted (Boxes.corners b)) points then Some b else None
  in
  Option.all of_solid w.solids

(* The images fill what the walls do: no more, and the volume is the same. *)
let same_set walls images =
  match (Option.all boxes walls, Option.all boxes images) with
  | Some walls, Some images -> List.for_all (Boxes.cover (List.concat walls)) (List.concat images)
  | _ -> false

(** {2 Laws} *)

let value (x, y, z) =
  let constant e = Law.eval (fun _ -> Bug.fail __POS__ "a constant law reads a variable") e in
  match (constant x, constant y, constant z) with
  | Ok x, Ok y, Ok z -> Some (Vec.make x y z)
  | _ -> None

(* Velocities with their weights, each once and in order. *)
let weighted kicks =
  let put found (v, w) =
    match found with
    | (u, sum) :: rest when Vec.equal u v -> (u, Rat.add sum w) :: rest
    | _ -> (v, w) :: found
  in
  List.fold_left put [] (List.sort (fun (u, _) (v, _) -> Vec.compare u v) kicks)

(* What a constant law gives, with weights; [None] of others. *)
let given (law : Law.t) =
  let kick (k : Law.kick) =
    match (value k.motion.velocity, Law.eval (fun _ -> Rat.zero) k.weight) with
    | Some v, Ok w -> Some (v, w)
    | _ -> None
  in
  if not (Law.never_fails law) then None
  else
    match law with
    | Inertial -> Some []
    | Gives m -> Option.map (fun v -> [ (v, Rat.one) ]) (value m.velocity)
    | Choose kicks -> Option.all kick kicks

let keeps_law map law =
  let equal (u, w) (v, x) = Vec.equal u v && Rat.equal w x in
  let image (v, w) = (apply map v, w) in
  let same kicks = List.equal equal (weighted kicks) (weighted (List.map image kicks)) in
  Option.fold ~none:false ~some:same (given law)

(** {2 Behaviours} *)

(* A push has a direction, of which nothing is known here. *)
let pushes (b : Behaviour.t) =
  match b with
  | Weak (_, { push; _ }, _) | Strong (_, push, _) -> Rat.sign push <> 0
  | Nil | Open _ | Delay _ | Wait _ | Sum _ | Call _ -> false

(* A part whose feature is named stays where it is, with the feature. *)
let keeps_site (leaf : Model.leaf) ~at (site : Site.t) =
  let part = leaf.parts.(site.part) in
  let stays vertices =
    let points = List.map (fun v -> Vec.add part.offset (Solid.vertex part.solid v)) vertices in
    equal_points (sorted points) (sorted (List.map at points))
  in
  stays (List.init (Array.length part.solid.vertices) Fun.id) && stays (Solid.corners part.solid site.feature)

(* So do those of each channel that the leaf may come to offer, and of each bond that it has. *)
let keeps_channels (m : Model.t) (p : State.process) (l : State.leaf) ~at =
  let kept = keeps_site m.leaves.(l.leaf) ~at in
  let is_kept (c : Behaviour.channel) = List.for_all kept c.surface in
  let changes b = pushes b || not (List.for_all is_kept (Behaviour.channels b)) in
  let keeps_end (e : State.finish) = e.at <> l.leaf || kept e.site in
  (not (Behaviour.some_prefix m.definitions ~behind:(fun _ -> true) changes l.behaviour.term))
  && Array.for_all (fun (b : State.bond) -> keeps_end b.one && keeps_end b.two) p.bonds

(* It never does anything but move. *)
let is_idle (m : Model.t) (b : Behaviour.aged) =
  not (Behaviour.some_prefix m.definitions ~behind:(fun _ -> true) (fun _ -> true) b.term)

(* A fixed leaf that another one comes to: both are alone, of one behaviour that does nothing. *)
let are_plain (m : Model.t) (initial : State.t) i j =
  let alone k = match State.home initial k with Some { leaves = [| l |]; _ } -> Some l.behaviour | _ -> None in
  match (alone i, alone j) with
  | Some a, Some b -> Behaviour.equal_aged a b && is_idle m a
  | _ -> false

(* Nothing counts of fixed bodies but the space that they fill: all others are walkers of one leaf that stop where
   they run into something, and nothing ever binds, splits or is absorbed. *)
let are_one_set (m : Model.t) (initial : State.t) =
  let fits (p : State.process) =
    match p.leaves with
    | [| l |] ->
      let leaf = m.leaves.(l.leaf) in
      is_idle m l.behaviour && (not leaf.absorbs) && (leaf.fixed || Law.draws leaf.law)
    | _ -> false
  in
  Model.stops_walkers m && Array.for_all fits initial.processes

(** {2 Formulas} *)

exception Not_mapped

(* What a number of the image is, in terms of the original. *)
let quantity g (q : Property.quantity) : Property.num =
  let signed r n : Property.num = if r.flipped then Neg n else n in
  match q with
  | Position (axis, leaf) ->
    (* It is the place of the centroid, which comes to that of the image, wherever the reference point does. *)
    let r = row g.map axis in
    Add (signed r (Quantity (Position (r.from, g.origin.(leaf)))), Const (Vec.component axis g.shift))
  | Velocity (axis, leaf) ->
    let r = row g.map axis in
    signed r (Quantity (Velocity (r.from, g.origin.(leaf))))
  | Momentum axis ->
    let r = row g.map axis in
    signed r (Quantity (Momentum r.from))
  | Bonds _ | Size _ | Processes | Speed2 _ | Distance2 _ | Energy | Time | Parameter _ ->
    Quantity (Atom.renamed_quantity (Array.get g.origin) q)
  | Spin _ | Spin2 _ | Angular _ -> raise Not_mapped

let fact g (f : Property.fact) : Property.fact =
  match f with
  | Bound _ | Same _ | Behaviour _ | Offers _ | Touching _ | Gone _ | Quiescent ->
    Atom.renamed_fact (Array.get g.origin) f
  | Event _ -> raise Not_mapped

let checked g atom = if List.exists (fun leaf -> g.origin.(leaf) < 0) (Atom.leaves atom) then raise Not_mapped

let rec num g : Property.num -> Property.num = function
  | Quantity q ->
    checked g (Atom.quantity q);
    quantity g q
  | n -> Parts.map_num ~num:(num g) ~prop:(prop g) n

and prop g : Property.prop -> Property.prop = function
  | Fact f ->
    checked g (Atom.fact f);
    Fact (fact g f)
  | p -> Parts.map_prop ~num:(num g) ~prop:(prop g) p

let keeps map normal compare formulas =
  let same f = match map f with image -> compare (normal f) (normal image) = 0 | exception Not_mapped -> false in
  List.for_all same formulas

(** {2 All of it} *)

let applies (m : Model.t) = Option.is_none m.rigid && Option.is_none m.round_velocity && Array.length m.ranges = 0

(* The leaves with what becomes of them; [None] where fixed bodies come to be elsewhere. *)
let with_origins m initial walls g =
  let images = List.map (image_of (fun v -> Vec.add g.shift (apply g.map v))) walls in
  match origins walls images with
  | Some pairs ->
    List.iter (fun (leaf, origin) -> g.origin.(leaf) <- origin) pairs;
    true
  | None ->
    List.iter (fun w -> g.origin.(w.leaf) <- -1) walls;
    are_one_set m initial && same_set walls images

let keeps_leaf (m : Model.t) initial g (p, (l : State.leaf)) =
  let leaf = m.leaves.(l.leaf) and origin = g.origin.(l.leaf) in
  if leaf.fixed then
    let at v = Vec.sub (Vec.add g.shift (apply g.map (Vec.add l.position v))) l.position in
    origin < 0 || ((origin = l.leaf || are_plain m initial l.leaf origin) && keeps_channels m p l ~at)
  else
    match moved g.map leaf with
    | None -> false
    | Some by ->
      g.own.(l.leaf) <- by;
      keeps_law g.map leaf.law && keeps_channels m p l ~at:(fun v -> Vec.sub (apply g.map v) by)

let whole (m : Model.t) initial walls middle ~predicates ~numbers map =
  let count = Array.length m.leaves in
  let shift = Vec.sub middle (apply map middle) in
  let g = { map; shift; own = Array.make count Vec.zero; origin = Array.init count Fun.id } in
  if with_origins m initial walls g
  && List.for_all (keeps_leaf m initial g) (State.by_leaf initial)
  && keeps (prop g) Normal.prop Order.prop predicates
  && keeps (num g) Normal.num Order.num numbers
  then Some g
  else None

let image g (m : Model.t) (p : State.process) =
  let at (l : State.leaf) =
    if m.leaves.(l.leaf).fixed then l
    else { l with position = Vec.add (Vec.add g.shift g.own.(l.leaf)) (apply g.map l.position) }
  in
  let draw : State.draw -> State.draw = function
    | Waits -> Waits
    | Drawn given -> Drawn { given with velocity = apply g.map given.velocity }
  in
  State.map_leaves at p
  |> State.with_velocity (apply g.map p.velocity)
  |> State.with_draw (Option.map draw p.draw)

(* Where the bodies and what the laws give come to. *)
let seen (m : Model.t) (initial : State.t) ~image ~map =
  let gives (l : State.leaf) = Option.value (given m.leaves.(l.leaf).law) ~default:[] in
  let of_leaf (l : State.leaf) = l.position :: List.map (fun (v, _) -> map v) (gives l) in
  let of_process p =
    let p = image p in
    p.State.velocity :: List.concat_map of_leaf (Array.to_list p.leaves)
  in
  List.concat_map of_process (Array.to_list initial.processes)

(* Of those that do the same to all that moves, one is enough: none if that is nothing. *)
let distinct m initial maps =
  let add known g =
    let there = seen m initial ~image:(image g m) ~map:(apply g.map) in
    if List.exists (fun (_, other) -> equal_points there other) known then known else (Some g, there) :: known
  in
  List.filter_map fst (List.rev (List.fold_left add [ (None, seen m initial ~image:Fun.id ~map:Fun.id) ] maps))

let find (m : Model.t) ~(initial : State.t) ~predicates ~numbers =
  match walls m initial with
  | _ :: _ as walls when applies m ->
    let { Boxes.low; high } = box (List.concat_map (fun w -> List.concat w.solids) walls) in
    distinct m initial (List.filter_map (whole m initial walls (Vec.middle low high) ~predicates ~numbers) maps)
  | _ -> []
