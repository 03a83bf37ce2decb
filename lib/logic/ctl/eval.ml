open Scc_exact
open Scc_chance
module Map = Map.Make (Timed_formula)

type predicates = {
  at : int -> int -> Truth.t;
  along : int -> int -> Timeline.extent -> Truth.t Timeline.t;
  steady : int -> bool;
}

type value = { lower : Positions.t; upper : Positions.t }
type measured = { least : Answer.t; most : Answer.t }

type asked = {
  decide : bool;
  side : Timed_formula.side;
  formula : Timed_formula.t;
  position : Positions.position;
}

type t = {
  index : Timed_graph.index;
  predicates : predicates;
  effort : Effort.t;
  still : Timed_formula.t -> Timed_formula.t option;
  mutable values : value Map.t;
  mutable fresh : Timed_formula.t list;  (** what got its value since something was forgotten *)
  mutable recent : (asked * measured) list;  (** the last probabilities, which explanations ask for again *)
  is_chain : bool Lazy.t;
}

let create ?(effort = Effort.default) ?(still = fun _ -> None) index predicates =
  let is_chain = lazy (Timed_graph.is_chain (Timed_graph.graph index)) in
  { index; predicates; effort; still; values = Map.empty; fresh = []; recent = []; is_chain }

let index t = t.index
let graph t = Timed_graph.graph t.index
let effort t = t.effort
let predicates t = t.predicates

type until = {
  quantifier : Timed_formula.quantifier;
  bound : Timed_formula.bound;
  claim : Timed_formula.t;
  left : Timed_formula.t;
  right : Timed_formula.t;
}

let opposite : Timed_formula.t -> Timed_formula.t = function Not f -> f | f -> Not f

(* A run that has come to where nothing leads to the right side any more has not got there. *)
let guarded t (left : Timed_formula.t) right : Timed_formula.t =
  match (t.still right, left) with
  | None, _ -> left
  | Some p, And (first :: _) when Timed_formula.compare p first = 0 -> left
  | Some p, And fs -> And (p :: fs)
  | Some p, _ -> And [ p; left ]

let still t right = guarded t (And []) right

let as_until t (formula : Timed_formula.t) =
  let until quantifier bound claim right = { quantifier; bound; claim; left = guarded t claim right; right } in
  match formula with
  | Until (quantifier, bound, left, right) -> Some (until quantifier bound left right, false)
  | Finally (quantifier, bound, right) -> Some (until quantifier bound (And []) right, false)
  | Globally (q, bound, f) -> Some (until (Timed_formula.dual q) bound (And []) (opposite f), true)
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

let all_known t f g = is_exact f && is_exact g && Timed_graph.complete t.index

let until_of_runs t (q : Interval.quantifier) (bound : Timed_formula.bound) f g =
  let from_start ~generous high f g =
    match (q, high) with
    | Some_run, None -> Until.some t.index ~generous ~f ~g
    | Every_run, None -> Until.every t.index ~generous ~f ~g
    | Some_run, Some bound -> Bounded.some t.index ~generous ~bound ~f ~g
    | Every_run, Some bound -> Bounded.every t.index ~generous ~bound ~f ~g
  in
  let empty = match bound.high with None -> false | Some h -> Rat.compare h bound.low < 0 in
  if empty then exactly (Positions.constant (graph t) false)
  else
    both ~exact:(all_known t f g) (fun ~generous side ->
        let f = side f and g = side g in
        if Rat.sign bound.low <= 0 then from_start ~generous bound.high f g
        else
          let high = Option.map (fun h -> Rat.sub h bound.low) bound.high in
          let phi = from_start ~generous high f g in
          Interval.set (Interval.solve t.index q ~generous ~from:bound.low ~f ~phi))

(* A probability grows with what satisfies f and g; whether that is for or against the test, it tells. *)
let likely t ({ side; test } : Timed_formula.chance) bound f g =
  let question generous side_of : Likelihood.question =
    { graph = graph t; side; bound; f = side_of f; g = side_of g; generous }
  in
  let effort = { t.effort with bound = Some test } in
  let low = question false (fun v -> v.lower) and high = question true (fun v -> v.upper) in
  let surely a = Answer.holds a test = Some true and perhaps a = Answer.holds a test <> Some false in
  let upwards = match test.relation with At_least_so | More -> true | At_most | Less -> false in
  if upwards then make (Likelihood.set low effort surely) (Likelihood.set high effort perhaps)
  else make (Likelihood.set high effort surely) (Likelihood.set low effort perhaps)

let until t (q : Timed_formula.quantifier) bound f g =
  match q with
  | Exists -> until_of_runs t Some_run bound f g
  | All -> until_of_runs t Every_run bound f g
  | Chance chance -> likely t chance bound f g

(** {2 Formulas} *)

let predicate t p =
  let { at; along; steady } = t.predicates in
  let along = if steady p then None else Some (along p) in
  let lower, upper = Positions.of_truth (graph t) ~at:(at p) ~along in
  { lower; upper }

let rec value t (f : Timed_formula.t) =
  match Map.find_opt f t.values with
  | Some v -> v
  | None ->
    let v = compute t f in
    t.values <- Map.add f v t.values;
    t.fresh <- f :: t.fresh;
    v

and compute t (f : Timed_formula.t) =
  match f with
  | Predicate p -> predicate t p
  | Not f -> not_ (value t f)
  | And [] -> exactly (Positions.constant (graph t) true)
  | Or [] -> exactly (Positions.constant (graph t) false)
  | And (f :: rest) -> List.fold_left (fun v g -> map2 ( && ) v (value t g)) (value t f) rest
  | Or (f :: rest) -> List.fold_left (fun v g -> map2 ( || ) v (value t g)) (value t f) rest
  | Next (Exists, f) -> some_next t (value t f)
  | Next (All, f) -> not_ (some_next t (value t (opposite f)))
  | Next (Chance _, _) -> Scc_base.Bug.fail __POS__ "a probability of the next transition"
  | Until _ | Finally _ | Globally _ -> (
      match as_until t f with
      | None -> Scc_base.Bug.fail __POS__ "an operator of time that is none"
      | Some (u, flipped) ->
        let left = value t u.left in
        let v = until t u.quantifier u.bound left (value t u.right) in
        if flipped then not_ v else v)

(* The formulas whose values {!compute} takes up, and theirs. *)
let parts t (f : Timed_formula.t) =
  match f with
  | Predicate _ -> []
  | Not f -> [ f ]
  | And list | Or list -> list
  | Next ((Exists | Chance _), f) -> [ f ]
  | Next (All, f) -> [ opposite f ]
  | Until _ | Finally _ | Globally _ ->
    Option.fold ~none:[] ~some:(fun (u, _) -> [ u.left; u.right ]) (as_until t f)

(* For each part the number of the last formula that it is part of; and for each number those of which it is that.
*)
type uses = { last : int Map.t; ending : Timed_formula.t list array }

let uses t formulas =
  let ending = Array.make (Array.length formulas) [] in
  let rec note i last f =
    if Map.mem f last then last
    else begin
      ending.(i) <- f :: ending.(i);
      List.fold_left (note i) (Map.add f i last) (parts t f)
    end
  in
  let last = ref Map.empty in
  for i = Array.length formulas - 1 downto 0 do
    last := note i !last formulas.(i)
  done;
  { last = !last; ending }

let done_with t uses i =
  let is_over f = match Map.find_opt f uses.last with Some last -> last <= i | None -> true in
  let forget f = t.values <- Map.remove f t.values in
  List.iter forget (List.filter is_over t.fresh);
  List.iter forget uses.ending.(i);
  t.fresh <- [];
  t.recent <- []

(* At one position, of which a probability is found without those of all others. *)
let pair_of v position = (Positions.mem v.lower position, Positions.mem v.upper position)

let interval t effort side bound f g position =
  let question generous side_of : Likelihood.question =
    { graph = graph t; side; bound; f = side_of f; g = side_of g; generous }
  in
  let low = question false (fun v -> v.lower) in
  if all_known t f g then
    let answer = Likelihood.at low effort position in
    (answer, answer)
  else Likelihood.at_both low (question true (fun v -> v.upper)) effort position

let measure t { decide; side; formula; position } =
  match as_until t formula with
  | None -> Scc_base.Bug.fail __POS__ "a probability of what is no until"
  | Some (u, flipped) ->
    let asked : Timed_formula.quantifier -> Answer.bound option = function
      | Chance { test; _ } -> Some test
      | All | Exists -> None
    in
    let effort = { t.effort with bound = if decide then asked u.quantifier else None } in
    let side = if flipped then Timed_formula.other_side side else side in
    let low, high = interval t effort side u.bound (value t u.left) (value t u.right) position in
    if flipped then { least = Answer.complement high; most = Answer.complement low }
    else { least = low; most = high }

let is_chain t = Lazy.force t.is_chain

(* What is found without a test is at least as good as what is found to decide it. Without choices both sides are
   one. *)
let answers t asked (known, _) =
  (asked.decide || not known.decide)
  && (asked.side = known.side || is_chain t)
  && Timed_formula.compare asked.formula known.formula = 0
  && asked.position.node = known.position.node
  && Algebraic.equal asked.position.offset known.position.offset

let most_recent = 4

let probability t ~decide side formula position =
  let asked = { decide; side; formula; position } in
  match List.find_opt (answers t asked) t.recent with
  | Some (_, measured) -> measured
  | None ->
    let measured = measure t asked in
    t.recent <- (asked, measured) :: List.filteri (fun i _ -> i < most_recent - 1) t.recent;
    measured

(* Both ends of a value may change at their own times. *)
let curve t side f node =
  match as_until t f with
  | None | Some ({ bound = { high = None; _ }; _ }, _) -> None
  | Some (({ bound = { high = Some high; _ } as bound; _ } as u), flipped) ->
    let side = if flipped then Timed_formula.other_side side else side in
    let f = value t u.left and g = value t u.right in
    let question generous side_of : Likelihood.question =
      { graph = graph t; side; bound; f = side_of f; g = side_of g; generous }
    in
    let low = question false (fun v -> v.lower) and high_end = question true (fun v -> v.upper) in
    let exact = all_known t f g in
    let merged a b = List.sort_uniq Timeline.compare_moment (a @ b) in
    let most = Effort.most_layers t.effort in
    let moments () =
      let moments q = Curve.moments ~most q node in
      let*? low = moments low in
      if exact then Some low else Option.map (merged low) (moments high_end)
    in
    let points moments =
      let at = Curve.horizons moments ~high in
      let values q = Curve.values q t.effort node (List.map snd at) in
      let least = values low in
      let most = if exact then least else values high_end in
      let measured a b =
        if flipped then { least = Answer.complement b; most = Answer.complement a } else { least = a; most = b }
      in
      List.map2 (fun (m, _) v -> (m, v)) at (List.map2 measured least most)
    in
    match moments () with
    | found -> Option.map (fun moments -> Ok (points moments)) found
    | exception Layers.Too_many over -> Some (Error (Layers.too_many ~most ~over high))

let rec decided t (f : Timed_formula.t) position =
  match f with
  | Not f -> (
      match decided t f position with
      | lower, upper -> (not upper, not lower))
  | And fs -> together ( && ) true t fs position
  | Or fs -> together ( || ) false t fs position
  | Until (Chance c, _, _, _) | Finally (Chance c, _, _) | Globally (Chance c, _, _) ->
    if Map.mem f t.values then pair_of (value t f) position
    else
      let { least; most } = probability t ~decide:true c.side f position in
      let upwards = match c.test.relation with At_least_so | More -> true | At_most | Less -> false in
      let for_it, against = if upwards then (least, most) else (most, least) in
      (Answer.holds for_it c.test = Some true, Answer.holds against c.test <> Some false)
  | Predicate _ | Next _ | Until _ | Finally _ | Globally _ -> pair_of (value t f) position

and together connect neutral t fs position =
  List.fold_left
    (fun (lower, upper) f ->
       let l, u = decided t f position in
       (connect lower l, connect upper u))
    (neutral, neutral) fs

let truth t f position =
  match decided t f position with true, _ -> Some true | false, true -> None | false, false -> Some false

let likely_run t (u : until) position =
  match u.quantifier with
  | All | Exists -> None
  | Chance { side; _ } ->
    let f = (value t u.left).lower and g = (value t u.right).lower in
    Likelihood.run { graph = graph t; side; bound = u.bound; f; g; generous = false } t.effort position
