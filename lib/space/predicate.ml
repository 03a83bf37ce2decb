open Scc_ctl
open Scc_exact
open Scc_calculus
open Scc_property
open Scc_evaluate

(* A number, or why there is none. *)
type value = (Rat.t, string) result

let memory = 1 lsl 12

(* A function of processes that remembers its last values. *)
let by_process c initial f =
  let catalogue = Network_lts.catalogue c in
  let known = Array.make memory Catalogue.nobody and values = Array.make memory initial in
  fun number ->
    let k = number land (memory - 1) in
    if known.(k) = number then values.(k)
    else begin
      let v = f (Catalogue.body catalogue number).process in
      known.(k) <- number;
      values.(k) <- v;
      v
    end

let leaves c = Array.length (Network_lts.model c).leaves

let fold c f acc (tuple : int array) =
  let n = leaves c in
  let rec from i acc =
    if i = n then acc
    else
      let p = tuple.(i) in
      from (i + 1) (if p = Catalogue.nobody then acc else f acc p)
  in
  from 0 acc

(* The number of the process of a leaf: it is in the slot of its first leaf, which comes no later. *)
let home_number c leaf =
  let catalogue = Network_lts.catalogue c in
  fun (tuple : int array) ->
    let rec from i =
      if i < 0 then Scc_base.Bug.fail __POS__ "a leaf of the model is not in the state"
      else if tuple.(i) <> Catalogue.nobody then
        let p = (Catalogue.body catalogue tuple.(i)).process in
        if State.has_leaf p leaf then tuple.(i) else from (i - 1)
      else from (i - 1)
    in
    from leaf

let home c leaf =
  let number = home_number c leaf in
  fun tuple -> (Catalogue.body (Network_lts.catalogue c) (number tuple)).process

let joins p q (b : State.bond) =
  (b.one.at = p && b.two.at = q) || (b.one.at = q && b.two.at = p)

let named name (b : State.bond) =
  match name with
  | None -> true
  | Some n -> String.equal n b.name

let count test bonds = Array.fold_left (fun n b -> if test b then n + 1 else n) 0 bonds

(* Of the atoms that are not judged here. *)
exception Moves

let axis (a : Property.axis) (v : Vec.t) =
  match a with
  | X -> v.x
  | Y -> v.y
  | Z -> v.z

let sum c quantity =
  let model = Network_lts.model c in
  let of_process (p : State.process) =
    match State.mass model p with
    | None -> Rat.zero
    | Some m -> quantity m p.velocity
  in
  let of_number = by_process c Rat.zero of_process in
  fun tuple : value -> Ok (fold c (fun acc p -> Rat.add acc (of_number p)) Rat.zero tuple)

let integer f tuple : value = Ok (Rat.of_int (f tuple))

let both f a b tuple : value =
  match (a tuple, b tuple) with
  | Ok x, Ok y -> f x y
  | (Error _ as e), _ | _, (Error _ as e) -> e

let rec num c (n : Property.num) : int array -> value =
  let model = Network_lts.model c in
  match n with
  | Const r -> fun _ -> Ok r
  | Quantity (Bonds (name, None)) ->
    let bonds = by_process c 0 (fun p -> count (named name) p.bonds) in
    integer (fold c (fun acc p -> acc + bonds p) 0)
  | Quantity (Bonds (name, Some (p, q))) ->
    let home = home c p in
    integer (fun t -> count (fun b -> named name b && joins p q b) (home t).bonds)
  | Quantity (Size leaf) ->
    let home = home c leaf in
    integer (fun t -> State.size model (home t))
  | Quantity Processes -> integer (fold c (fun acc _ -> acc + 1) 0)
  | Quantity (Velocity _ | Speed2 _ | Energy | Spin _ | Spin2 _) when Option.is_some model.rigid ->
    raise_notrace Moves
  | Quantity (Velocity (a, leaf)) ->
    let home = home c leaf in
    fun t -> Ok (axis a (home t).velocity)
  | Quantity (Speed2 leaf) ->
    let home = home c leaf in
    fun t -> Ok (Vec.norm2 (home t).velocity)
  | Quantity (Spin (a, leaf)) ->
    let home = home c leaf in
    fun t -> Ok (axis a (home t).spin)
  | Quantity (Spin2 leaf) ->
    let home = home c leaf in
    fun t -> Ok (Vec.norm2 (home t).spin)
  | Quantity (Momentum a) -> sum c (fun m v -> Rat.mul m (axis a v))
  | Quantity Energy -> sum c (fun m v -> Rat.div (Rat.mul m (Vec.norm2 v)) (Rat.of_int 2))
  | Neg a ->
    let a = num c a in
    fun t -> Result.map Rat.neg (a t)
  | Add (a, b) -> both (fun x y -> Ok (Rat.add x y)) (num c a) (num c b)
  | Sub (a, b) -> both (fun x y -> Ok (Rat.sub x y)) (num c a) (num c b)
  | Mul (a, b) -> both (fun x y -> Ok (Rat.mul x y)) (num c a) (num c b)
  | Div (a, b) ->
    let undefined = Error ("division by zero in " ^ Show.num model n) in
    let quotient x y = if Rat.sign y = 0 then undefined else Ok (Rat.div x y) in
    both quotient (num c a) (num c b)
  | If (p, a, b) -> (
      let p = prop c p and a = num c a and b = num c b in
      fun t ->
        match p t with
        | Truth.True -> a t
        | False -> b t
        | Undecided reason -> Error reason)
  | Count props ->
    let props = List.map (prop c) props in
    fun t ->
      List.fold_left
        (fun n p ->
           match (n, p t) with
           | Error _, _ | _, Truth.False -> n
           | Ok n, True -> Ok (Rat.add n Rat.one)
           | Ok _, Undecided reason -> Error reason)
        (Ok Rat.zero) props
  | Quantity (Position _ | Distance2 _ | Angular _ | Time) -> raise_notrace Moves

and prop c (p : Property.prop) : int array -> Truth.t =
  let model = Network_lts.model c in
  match p with
  | Bool b -> fun _ -> Truth.of_bool b
  | Compare (op, a, b) ->
    let a = num c a and b = num c b in
    fun t ->
      (match (a t, b t) with
       | Ok x, Ok y -> Truth.of_bool (Law.compare_rationals op x y)
       | Error reason, _ | _, Error reason -> Truth.Undecided reason)
  | Fact (Bound (p, q)) ->
    let home = home c p in
    fun t -> Truth.of_bool (Array.exists (joins p q) (home t).bonds)
  | Fact (Same (p, q)) ->
    let home = home c p in
    fun t -> Truth.of_bool (State.has_leaf (home t) q)
  | Fact (Behaviour (leaf, _) | Offers (leaf, _, _)) ->
    let network process = State.make ~processes:[ process ] ~step:None ~time:None in
    let alone = by_process c Truth.False (fun process -> Trajectory.holds model (network process) p) in
    let number = home_number c leaf in
    fun t -> alone (number t)
  | Fact (Event e) -> fun t -> Truth.of_bool (Network_lts.arrived c t e)
  | Not a ->
    let a = prop c a in
    fun t -> Truth.not_ (a t)
  | And list -> connective c Truth.and_ Truth.True list
  | Or list -> connective c Truth.or_ Truth.False list
  | Fact (Touching _ | Quiescent) -> raise_notrace Moves

and connective c join unit list =
  let list = List.map (prop c) list in
  fun t -> List.fold_left (fun acc p -> join acc (p t)) unit list

(* Along the trajectory of the whole state. *)
let anywhere c p : On_the_fly.predicate =
  let model = Network_lts.model c in
  let timeline tuple extent =
    let state = Catalogue.decode (Network_lts.catalogue c) tuple in
    Trajectory.prop (Trajectory.make ~arrived:(Network_lts.arrived c tuple) model state extent) p
  in
  { at = (fun tuple -> (timeline tuple Timeline.Instant).start); along = Some timeline }

let make c p =
  match prop c p with
  | exception Moves -> anywhere c p
  | at when Formula.has_events (State p) ->
    (* What has just happened is past as soon as time passes. *)
    let later tuple = at (Network_lts.unmarked c tuple) in
    { at; along = Some (fun tuple extent -> Timeline.after_start extent (at tuple) (later tuple)) }
  | at -> { at; along = None }
