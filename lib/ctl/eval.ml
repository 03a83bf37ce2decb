open Scc_exact
module Map = Map.Make (Formula)

type predicates = {
  at : int -> int -> Truth.t;
  along : int -> int -> Timeline.extent -> Truth.t Timeline.t;
  steady : int -> bool;
}

type value = { lower : Positions.t; upper : Positions.t }
type t = { index : Timed_graph.index; predicates : predicates; mutable values : value Map.t }

let create index predicates = { index; predicates; values = Map.empty }
let index t = t.index
let graph t = Timed_graph.graph t.index
let predicates t = t.predicates

type until = {
  quantifier : Formula.quantifier;
  bound : Formula.bound;
  left : Formula.t;
  right : Formula.t;
}

let dual : Formula.quantifier -> Formula.quantifier = function
  | All -> Exists
  | Exists -> All

let opposite : Formula.t -> Formula.t = function Not f -> f | f -> Not f

let as_until : Formula.t -> (until * bool) option = function
  | Until (quantifier, bound, left, right) -> Some ({ quantifier; bound; left; right }, false)
  | Finally (quantifier, bound, right) -> Some ({ quantifier; bound; left = And []; right }, false)
  | Globally (q, bound, f) ->
    Some ({ quantifier = dual q; bound; left = And []; right = opposite f }, true)
  | Predicate _ | Not _ | And _ | Or _ | Next _ -> None

(** {2 Pairs of sets} *)

let is_exact v = v.lower == v.upper
let exactly set = { lower = set; upper = set }

(* Equal sets become one, which spares what is built on them half of the work. *)
let make lower upper = if Positions.equal lower upper then exactly lower else { lower; upper }

let not_ v =
  let upper = Positions.not_ v.lower in
  { lower = (if is_exact v then upper else Positions.not_ v.upper); upper }

let map2 f a b =
  let lower = Positions.map2 f a.lower b.lower in
  if is_exact a && is_exact b then exactly lower else make lower (Positions.map2 f a.upper b.upper)

(* From operators on sets that take what is not known generously or not. *)
let both ~exact operator =
  let lower = operator ~generous:false (fun v -> v.lower) in
  if exact then exactly lower else make lower (operator ~generous:true (fun v -> v.upper))

let some_next t f =
  both
    ~exact:(is_exact f && Timed_graph.complete t.index)
    (fun ~generous side -> Until.next t.index ~generous (side f))

let until t (q : Formula.quantifier) (bound : Formula.bound) f g =
  let exact = is_exact f && is_exact g && Timed_graph.complete t.index in
  let from_start ~generous high f g =
    match (q, high) with
    | Exists, None -> Until.some t.index ~generous ~f ~g
    | All, None -> Until.every t.index ~generous ~f ~g
    | Exists, Some bound -> Bounded.some t.index ~generous ~bound ~f ~g
    | All, Some bound -> Bounded.every t.index ~generous ~bound ~f ~g
  in
  let empty = match bound.high with None -> false | Some h -> Rat.compare h bound.low < 0 in
  if empty then exactly (Positions.constant (graph t) false)
  else
    both ~exact (fun ~generous side ->
        let f = side f and g = side g in
        if Rat.sign bound.low <= 0 then from_start ~generous bound.high f g
        else
          let high = Option.map (fun h -> Rat.sub h bound.low) bound.high in
          let phi = from_start ~generous high f g in
          Interval.set (Interval.solve t.index q ~generous ~from:bound.low ~f ~phi))

(** {2 Formulas} *)

let predicate t p =
  let { at; along; steady } = t.predicates in
  let along = if steady p then None else Some (along p) in
  let lower, upper = Positions.of_truth (graph t) ~at:(at p) ~along in
  { lower; upper }

let rec value t (f : Formula.t) =
  match Map.find_opt f t.values with
  | Some v -> v
  | None ->
    let v = compute t f in
    t.values <- Map.add f v t.values;
    v

and compute t (f : Formula.t) =
  match f with
  | Predicate p -> predicate t p
  | Not f -> not_ (value t f)
  | And [] -> exactly (Positions.constant (graph t) true)
  | Or [] -> exactly (Positions.constant (graph t) false)
  | And (f :: rest) -> List.fold_left (fun v g -> map2 ( && ) v (value t g)) (value t f) rest
  | Or (f :: rest) -> List.fold_left (fun v g -> map2 ( || ) v (value t g)) (value t f) rest
  | Next (Exists, f) -> some_next t (value t f)
  | Next (All, f) -> not_ (some_next t (value t (opposite f)))
  | Until _ | Finally _ | Globally _ -> (
      match as_until f with
      | None -> Scc_base.Bug.fail __POS__ "an operator of time that is none"
      | Some (u, flipped) ->
        let left = value t u.left in
        let v = until t u.quantifier u.bound left (value t u.right) in
        if flipped then not_ v else v)

(* The formulas whose values {!compute} takes up, and theirs. *)
let parts (f : Formula.t) =
  match f with
  | Predicate _ -> []
  | Not f -> [ f ]
  | And list | Or list -> list
  | Next (Exists, f) -> [ f ]
  | Next (All, f) -> [ opposite f ]
  | Until _ | Finally _ | Globally _ ->
    Option.fold ~none:[] ~some:(fun (u, _) -> [ u.left; u.right ]) (as_until f)

let retain t formulas =
  let rec need known f = if Map.mem f known then known else List.fold_left need (Map.add f () known) (parts f) in
  let needed = List.fold_left need Map.empty formulas in
  t.values <- Map.filter (fun f _ -> Map.mem f needed) t.values

let truth t f position =
  let v = value t f in
  if Positions.mem v.lower position then Some true
  else if Positions.mem v.upper position then None
  else Some false
