open Scc_ctl
open Scc_exact
open Scc_polyhedra
open Scc_offsets
open Scc_calculus
open Scc_semantics
open Scc_motion
open Scc_property
open Scc_evaluate

type view = { zone : Zone.t; passing : bool; quiescent : Polyhedron.t list }
type context = { instant : Zone_parts.context; events : Property.event array }

let context instant ~events = { instant; events }

(* {1 From region to region} *)

type 'a cells = (Polyhedron.t * 'a) list

let everywhere v x : 'a cells = [ (v.zone.Zone.set, x) ]

let meet p q =
  if p == q then Some p
  else
    let both = Polyhedron.inter p q in
    if Polyhedron.is_empty both then None else Some both

let map2 f (a : 'a cells) (b : 'b cells) : 'c cells =
  let with_ (p, x) = List.filter_map (fun (q, y) -> Option.map (fun r -> (r, f x y)) (meet p q)) b in
  List.concat_map with_ a

(* Where the constraint holds, and where not. *)
let by_constraint region c =
  let holds, fails = Region.split region [ c ] in
  List.map (fun p -> (p, true)) (Option.to_list holds) @ List.map (fun p -> (p, false)) fails

(* {1 Numbers} *)

type value = (Linear.t, string) result

(* What is affine in the variables, by its values at points. Only places are looked at, which may be anywhere. *)
let interpolated n f =
  let at point = f (Array.init n point) in
  let constant = at (fun _ -> Rat.zero) in
  let slope i = Rat.sub (at (fun k -> if k = i then Rat.one else Rat.zero)) constant in
  Linear.make ~constant (Array.init n slope)

let not_linear what = Error (what ^ " is not linear in what is not known")

module View = struct
  type nonrec context = context
  type t = view
  type number = value cells
  type truth = Truth.t cells

  let semantics c = c.instant.Zone_parts.semantics
  let model c = Semantics.model (semantics c)
  let model_at c v point = Semantics.model (Zone_parts.semantics_at c.instant v.zone point)

  (* Whether the parts of leaves are at known places in them. *)
  let are_known c leaves =
    let known (p : Model.part) = Option.is_none p.open_offset in
    List.for_all (fun i -> Array.for_all known (model c).leaves.(i).parts) leaves

  let constant q v = everywhere v (Ok (Linear.constant (Zone.dimension v.zone) q))
  let home v leaf = State.home v.zone.skeleton leaf
  let gone c leaf v = everywhere v (Error (Meaning.of_the_gone (model c) leaf))

  let now curve =
    match Path.now curve with
    | Some q -> q
    | None -> Scc_base.Bug.fail __POS__ "a straight path that is not followed"

  let processes v point = Array.to_list (Zone.at v.zone point).processes

  let of_process c v leaf curve =
    let n = Zone.dimension v.zone in
    let at point =
      match State.home (Zone.at v.zone point) leaf with
      | Some p -> now (curve (Path.make (model_at c v point) p))
      | None -> Scc_base.Bug.fail __POS__ "a leaf that is gone"
    in
    everywhere v (Ok (interpolated n at))

  let quantity c (q : Meaning.quantity) v =
    let n = Zone.dimension v.zone in
    match q with
    | Of_process (leaf, curve) -> if home v leaf = None then gone c leaf v else of_process c v leaf curve
    | Counted (leaf, count) ->
      let k = match home v leaf with None -> 0 | Some p -> count p in
      constant (Rat.of_int k) v
    | Of_two (i, j, curve) ->
      if home v i = None then gone c i v
      else if home v j = None then gone c j v
      else if Place.is_constant (Place.sub v.zone.places.(i) v.zone.places.(j)) && are_known c [ i; j ] then
        let s = Zone.at v.zone (Array.make n Rat.zero) in
        let path leaf = Path.make (model c) (Option.get (State.home s leaf)) in
        constant (now (curve (path i) (path j))) v
      else everywhere v (not_linear "a distance")
    | Sum curve ->
      let at point =
        let model = model_at c v point in
        let add sum p = Rat.add sum (now (curve (Path.make model p))) in
        List.fold_left add Rat.zero (processes v point)
      in
      everywhere v (Ok (interpolated n at))
    | Number (_, count) ->
      let all = Array.fold_left (fun k p -> k + count p) 0 v.zone.skeleton.processes in
      constant (Rat.of_int all) v
    | Time -> (
        match v.zone.time with
        | Some t -> everywhere v (Ok t)
        | None -> Scc_base.Bug.fail __POS__ "time is asked for, and not kept")
    | Parameter i -> everywhere v (Ok v.zone.parameters.(i))

  let lift2 f = map2 (fun a b -> Result.bind a (fun a -> Result.bind b (f a)))
  let neg = List.map (fun (p, a) -> (p, Result.map Linear.neg a))
  let add = lift2 (fun a b -> Ok (Linear.add a b))
  let sub = lift2 (fun a b -> Ok (Linear.sub a b))

  let mul =
    lift2 (fun (a : Linear.t) (b : Linear.t) ->
        if Linear.is_constant a then Ok (Linear.scale a.constant b)
        else if Linear.is_constant b then Ok (Linear.scale b.constant a)
        else not_linear "a product")

  let div ~reason =
    lift2 (fun a (b : Linear.t) ->
        if not (Linear.is_constant b) then not_linear "a quotient"
        else if Rat.sign b.constant = 0 then Error reason
        else Ok (Linear.scale (Rat.div Rat.one b.constant) a))

  let restrict cells region = List.filter_map (fun (p, x) -> Option.map (fun r -> (r, x)) (meet p region)) cells

  let choose truth yes no =
    let of_cell (region, (t : Truth.t)) =
      match t with
      | True -> restrict (yes ()) region
      | False -> restrict (no ()) region
      | Undecided reason -> [ (region, Error reason) ]
    in
    List.concat_map of_cell truth

  let count =
    map2 (fun (n : value) (t : Truth.t) ->
        match (n, t) with
        | Error _, _ | Ok _, False -> n
        | Ok n, True -> Ok (Linear.add n (Linear.constant (Linear.dimension n) Rat.one))
        | Ok _, Undecided reason -> Error reason)

  let bool b v = everywhere v (Truth.of_bool b)
  let not_ = List.map (fun (p, t) -> (p, Truth.not_ t))
  let and_ = map2 Truth.and_
  let is_false = List.for_all (fun (_, t) -> Truth.equal t Truth.False)

  let compare (op : Law.comparison) a b =
    let judged region (a : Linear.t) b =
      let holds c = List.map (fun (p, t) -> (p, Truth.of_bool t)) (by_constraint region c) in
      match op with
      | Lt -> holds (Constraint.less a b)
      | Le -> holds (Constraint.at_most a b)
      | Gt -> holds (Constraint.greater a b)
      | Ge -> holds (Constraint.at_least a b)
      | Eq -> holds (Constraint.equals a b)
      | Ne -> not_ (holds (Constraint.equals a b))
    in
    let of_cell (region, (a, b)) =
      match (a, b) with
      | Ok a, Ok b -> judged region a b
      | Error reason, _ | _, Error reason -> [ (region, Truth.Undecided reason) ]
    in
    List.concat_map of_cell (map2 (fun a b -> (a, b)) a b)

  (* {2 Facts} *)

  let touching c i j v =
    let m = model c in
    let parts leaf =
      match home v leaf with
      | None -> []
      | Some p -> List.filter (fun (part : Zone_parts.part) -> part.leaf = leaf) (Zone_parts.parts m v.zone p)
    in
    let pair found (a, b) =
      let obstacle = c.instant.obstacle a.Zone_parts.solid b.Zone_parts.solid in
      let look (region, touch) =
        if touch then [ (region, true) ]
        else
          Touching_cells.make obstacle ~offset:(Zone_parts.offset a b) region
          |> List.map (fun (p, relation) -> (p, match relation with Touching_cells.Apart -> false | _ -> true))
      in
      List.concat_map look found
    in
    let ones = parts i and twos = parts j in
    let pairs = Scc_data.Lists.product ones twos in
    List.map (fun (p, t) -> (p, Truth.of_bool t)) (List.fold_left pair (everywhere v false) pairs)

  let behaviour v leaf test =
    match home v leaf with None -> false | Some p -> test (State.leaf_of p leaf).behaviour

  let in_some v regions =
    let u = Union.of_polyhedra (Zone.dimension v.zone) regions in
    let all = Union.of_polyhedron v.zone.set in
    List.map (fun p -> (p, Truth.True)) (Union.pieces (Union.disjoint u))
    @ List.map (fun p -> (p, Truth.False)) (Union.pieces (Union.difference all u))

  let fact c (f : Meaning.fact) v =
    match f with
    | Missing leaf -> bool (home v leaf = None) v
    | In_process (leaf, test) -> bool (match home v leaf with None -> false | Some p -> test p) v
    | In_behaviour (leaf, test) -> bool (behaviour v leaf test) v
    | Touch (i, j, _) -> touching c i j v
    | Rest _ -> in_some v v.quiescent
    | Arrival event ->
      let is i = Formula.equal_event c.events.(i) event in
      bool ((not v.passing) && List.exists is v.zone.arrived) v
end

module Over_zones = Terms.Make (View)

let truth = Over_zones.prop
let number = Over_zones.num

let possible c prop v =
  List.filter_map (fun (p, t) -> if Truth.equal t Truth.False then None else Some p) (truth c prop v)
