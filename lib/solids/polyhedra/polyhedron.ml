open Scc_exact

(* A corner of the closure, and the constraints that are tight there, taken as not strict. *)
type corner = { at : Rat.t array; tight : Constraint.t list }

type body = {
  constraints : Constraint.t list;
  simplex : Simplex.t;
  minimal : Minimal.t Lazy.t;
  corner : corner Lazy.t;
  others : corner list Lazy.t;  (** so that each constraint is tight at one of all *)
}

(* No body: no point. The constraints are those of the simplex that no later one makes superfluous at a glance, the
   last one first. *)
type t = { dimension : int; body : body option }

let empty dimension = { dimension; body = None }

(* {1 Corners} *)

let corner_of halves at = { at; tight = List.filter (fun c -> Constraint.mem (Constraint.tight c) at) halves }

(* Equalities are two inequalities. *)
let halves form = List.map Constraint.closed (List.concat_map Constraint.halves (Minimal.constraints form))

let other_corners dimension halves first =
  let closed = Option.get (Simplex.of_constraints dimension halves) in
  let is_met corners c = List.exists (fun k -> List.exists (fun d -> d == c) k.tight) corners in
  let add corners c =
    if is_met corners c then corners
    else
      match Simplex.add closed (Constraint.tight c) with
      | Some face -> corner_of halves (Simplex.closed_point face) :: corners
      | None -> corners
  in
  List.fold_left add [ first ] halves |> List.filter (fun k -> k != first)

let body dimension constraints simplex minimal =
  let halves = lazy (halves (Lazy.force minimal)) in
  let corner = lazy (corner_of (Lazy.force halves) (Simplex.closed_point simplex)) in
  let others = lazy (other_corners dimension (Lazy.force halves) (Lazy.force corner)) in
  Some { constraints; simplex; minimal; corner; others }

let with_constraints dimension simplex constraints =
  { dimension; body = body dimension constraints simplex (lazy (Minimal.make simplex constraints)) }

let universe n = with_constraints n (Simplex.universe n) []

(* The constraints that still tell something beside c; or that c tells nothing, or leaves no point. *)
let rec beside c told = function
  | [] -> `New (List.rev told)
  | d :: rest -> (
      match Constraint.glance c d with
      | Follows -> `Known
      | Excludes -> `No_point
      | Implies -> beside c told rest
      | Unrelated -> beside c (d :: told) rest)

let add p c =
  match p.body with
  | None -> p
  | Some _ when Constraint.truth c = Some true -> p
  | Some body -> (
      match beside c [] body.constraints with
      | `Known -> p
      | `No_point -> empty p.dimension
      | `New others -> (
          match Simplex.add body.simplex c with
          | None -> empty p.dimension
          | Some simplex -> with_constraints p.dimension simplex (c :: others)))

let add_all = List.fold_left add
let of_constraints n constraints = add_all (universe n) constraints

let of_minimal dimension (form : Minimal.t) =
  let constraints = Minimal.constraints form in
  { dimension; body = body dimension constraints form.simplex (lazy form) }

let minimal p =
  match p.body with
  | None -> p
  | Some body -> of_minimal p.dimension (Lazy.force body.minimal)

let of_point point =
  let n = Array.length point in
  let fixed i x = Constraint.equals (Linear.variable n i) (Linear.constant n x) in
  of_constraints n (List.mapi fixed (Array.to_list point))

let box ranges =
  let n = Array.length ranges in
  let range i (low, high) =
    let x = Linear.variable n i in
    [ Constraint.at_least x (Linear.constant n low); Constraint.at_most x (Linear.constant n high) ]
  in
  of_constraints n (List.concat (List.mapi range (Array.to_list ranges)))

(* {1 What it is} *)

let dimension p = p.dimension
let is_empty p = p.body = None

let form p = Option.map (fun body -> Lazy.force body.minimal) p.body

let constraints p =
  match form p with
  | Some form -> Minimal.constraints form
  | None -> [ Constraint.less (Linear.constant p.dimension Rat.zero) (Linear.constant p.dimension Rat.zero) ]

let is_universe p = constraints p = []

let equalities p =
  match form p with
  | Some form -> form.equalities
  | None -> []

let affine_dimension p = if is_empty p then -1 else p.dimension - List.length (equalities p)

(* What was handed in, not minimal: enough to decide whether a point is in. *)
let raw p = Option.map (fun body -> body.constraints) p.body

let mem p point =
  match raw p with
  | None -> false
  | Some constraints -> List.for_all (fun c -> Constraint.mem c point) constraints

let point p = Option.map (fun body -> Simplex.point body.simplex) p.body
let corner p = Option.map (fun body -> Simplex.closed_point body.simplex) p.body

type bound = Simplex.bound = Unbounded | Bound of { value : Rat.t; attained : bool }

let supremum p f = Option.map (fun body -> Simplex.supremum body.simplex f) p.body
let infimum p f = Option.map (fun body -> Simplex.infimum body.simplex f) p.body

let limit = function
  | Some (Bound { value; _ }) -> Some value
  | Some Unbounded | None -> None

let is_bounded p =
  let bounded i =
    let x = Linear.variable p.dimension i in
    limit (supremum p x) <> None && limit (infimum p x) <> None
  in
  is_empty p || List.for_all bounded (List.init p.dimension Fun.id)

let implies p c =
  match p.body with
  | None -> true
  | Some body -> Simplex.implies body.simplex c

let relaxed change p =
  match form p with
  | None -> p
  | Some form -> of_constraints p.dimension (List.map change (Minimal.constraints form))

let closure = relaxed Constraint.closed
let relative_interior = relaxed Constraint.strict

(* {1 Comparing} *)

let included p q =
  if p.dimension <> q.dimension then Scc_base.Bug.fail __POS__ "polyhedra of different dimensions";
  match (p.body, raw q) with
  | None, _ -> true
  | Some _, None -> false
  | Some body, Some constraints ->
    (* a point that is at hand refutes most inclusions *)
    List.for_all (Simplex.satisfies body.simplex) constraints
    && List.for_all (Simplex.implies body.simplex) constraints

(* Some of the corners is outside of the closure of the other polyhedron, which has a point beyond a face there. *)
let sticks_out corners other =
  let closed = List.map Constraint.closed (Minimal.constraints (Lazy.force other.minimal)) in
  let is_outside k = List.exists (fun c -> not (Constraint.mem c k.at)) closed in
  let crosses c = not (Constraint.mem c (Lazy.force other.corner).at && Simplex.implies other.simplex c) in
  List.exists (fun k -> is_outside k && List.exists crosses k.tight) corners

let not_convex p q =
  match (p.body, q.body) with
  | Some a, Some b ->
    sticks_out [ Lazy.force a.corner ] b
    || sticks_out [ Lazy.force b.corner ] a
    || sticks_out (Lazy.force a.others) b
    || sticks_out (Lazy.force b.others) a
  | None, _ | _, None -> false

let equal p q = p == q || (included p q && included q p)

let inter p q =
  if p.dimension <> q.dimension then Scc_base.Bug.fail __POS__ "polyhedra of different dimensions";
  match raw q with
  | None -> q
  | Some constraints -> add_all p (List.rev constraints)

let disjoint p q = is_empty (inter p q)

let narrow = Z.of_int 100

let simple ~above ~below =
  let simplest = Fraction.simplest ~above ~below in
  match (above, below) with
  | Some low, Some high when Z.gt (Q.den simplest) narrow ->
    let quarter = Rat.div (Rat.sub high low) (Rat.of_int 4) in
    Fraction.simplest ~above:(Some (Rat.add low quarter)) ~below:(Some (Rat.sub high quarter))
  | _ -> simplest

let interior_point p =
  let fix (p, coordinates) i =
    let x = Linear.variable p.dimension i in
    let value =
      match (limit (infimum p x), limit (supremum p x)) with
      | Some low, Some high when Rat.equal low high -> low
      | above, below -> simple ~above ~below
    in
    (add p (Constraint.equals x (Linear.constant p.dimension value)), value :: coordinates)
  in
  if is_empty p then None
  else
    let _, coordinates = List.fold_left fix (p, []) (List.init p.dimension Fun.id) in
    Some (Array.of_list (List.rev coordinates))

(* {1 Maps} *)

let mapped p dimension change =
  match raw p with
  | None -> empty dimension
  | Some constraints -> of_constraints dimension (List.rev_map change constraints)

let preimage p ~dimension forms = mapped p dimension (fun c -> Constraint.substitute c ~dimension forms)

let substitute p i f =
  let n = p.dimension in
  preimage p ~dimension:n (Array.init n (fun k -> if k = i then f else Linear.variable n k))

let embed p ~dimension at = mapped p dimension (fun c -> Constraint.rename c ~dimension at)

(* A variable of which nothing is said is gone already. *)
let rec eliminate p variables =
  match form p with
  | None -> p
  | Some { equalities; inequalities; _ } -> (
      let occurs i = List.exists (fun c -> Constraint.mentions c i) in
      let left = List.filter (fun i -> occurs i equalities || occurs i inequalities) variables in
      match left with
      | [] -> p
      | _ :: _ -> eliminate (of_constraints p.dimension (Projection.step left ~equalities inequalities)) left)

let project p onto =
  let dimension = Array.length onto in
  let at = Array.make p.dimension (-1) in
  Array.iteri (fun k i -> at.(i) <- k) onto;
  let gone = List.filter (fun i -> at.(i) < 0) (List.init p.dimension Fun.id) in
  if p.dimension - List.length gone <> dimension then Scc_base.Bug.fail __POS__ "a variable twice";
  embed (minimal (eliminate p gone)) ~dimension at

(* The variables, if the forms are that, no two the same. *)
let distinct_variables n forms =
  let used = Array.make n false in
  let variable (f : Linear.t) =
    match List.filter (fun i -> Rat.sign (Linear.coefficient f i) <> 0) (List.init n Fun.id) with
    | [ i ] when (not used.(i)) && Linear.equal f (Linear.variable n i) ->
      used.(i) <- true;
      Some i
    | _ -> None
  in
  let found = Array.map variable forms in
  if Array.for_all Option.is_some found then Some (Array.map Option.get found) else None

let of_graph p forms =
  let n = p.dimension and m = Array.length forms in
  let all = n + m in
  let values = Array.init n (Linear.variable all) in
  let graph k f = Constraint.equals (Linear.variable all (n + k)) (Linear.compose f ~dimension:all values) in
  let whole = add_all (embed p ~dimension:all (Array.init n Fun.id)) (List.mapi graph (Array.to_list forms)) in
  project whole (Array.init m (fun k -> n + k))

let image p forms =
  match distinct_variables p.dimension forms with
  | Some variables -> project p variables
  | None -> of_graph p forms
