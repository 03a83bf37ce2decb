open Scc_exact

type place = {
  step : int;
  position : Positions.position;
  low : Algebraic.t;
  high : Algebraic.t option;
  clock : Rat.t;
}

let is_interval p =
  match p.high with None -> true | Some high -> Algebraic.compare p.low high < 0

type t = { run : Run.t; places : place array; again : int option; period : Rat.t }

(** {2 Places} *)

(* Where something changes inside the flow of a node that is a part of the formula. *)
let rec cuts e node acc (f : Timed_formula.t) =
  let value = Eval.value e f in
  let of_set acc set = Array.fold_left (fun acc c -> c :: acc) acc (Positions.along set node).Pieces.cuts in
  let acc = of_set (of_set acc value.lower) value.upper in
  match f with
  | Predicate _ -> acc
  | Not f | Next (_, f) | Finally (_, _, f) | Globally (_, _, f) -> cuts e node acc f
  | And fs | Or fs -> List.fold_left (cuts e node) acc fs
  | Until (_, _, f, g) -> cuts e node (cuts e node acc f) g

let node_place step node clock =
  { step; position = Positions.start node; low = Algebraic.zero; high = Some Algebraic.zero; clock }

(* The places of a flow after an offset, before another one or for ever. *)
let inside e formulas ~step ~clock node ~after ~before =
  let is_on c =
    Algebraic.compare c after > 0
    && match before with None -> true | Some b -> Algebraic.compare c b < 0
  in
  let cuts = List.sort_uniq Algebraic.compare (List.filter is_on (List.fold_left (cuts e node) [] formulas)) in
  let place offset low high = { step; position = { node; offset }; low; high; clock } in
  let interval low high = place (Algebraic.of_rat (Pieces.inside low high)) low high in
  let rec go found low = function
    | [] -> List.rev (interval low before :: found)
    | c :: later -> go (place c c (Some c) :: interval low (Some c) :: found) c later
  in
  go [] after cuts

(* The end of the interval of a flow in which an offset lies. *)
let end_of_interval e formulas graph node offset =
  let later = List.filter (fun c -> Algebraic.compare c offset > 0) (List.fold_left (cuts e node) [] formulas) in
  match (List.sort Algebraic.compare later, Timed_graph.flow graph node) with
  | c :: _, _ -> Some c
  | [], Lasts (d, _) -> Some (Algebraic.of_rat d)
  | [], (Forever | No_flow) -> None

let make e formulas (run : Run.t) =
  let graph = Eval.graph e in
  let start = run.start in
  let enter step node clock =
    if step = 0 && Positions.is_inside start then
      { step; position = start; low = start.offset; high = Some start.offset; clock }
    else node_place step node clock
  in
  let after step = if step = 0 then start.offset else Algebraic.zero in
  let flow step node clock before = inside e formulas ~step ~clock node ~after:(after step) ~before in
  let one (step, clock, acc) (s : Run.step) =
    let d = Timed_graph.duration graph s.source s.move in
    let acc = enter step s.source clock :: acc in
    match s.move with
    | Edge _ -> (step + 1, clock, acc)
    | Flow _ ->
      let places = flow step s.source clock (Some (Algebraic.of_rat d)) in
      (step + 1, Rat.add clock d, List.rev_append places acc)
  in
  let steps, clock, made = List.fold_left one (0, Rat.zero, []) run.steps in
  let last () = enter steps run.last clock in
  let up_to before = List.rev_append (flow steps run.last clock before) (last () :: made) in
  let made =
    match run.finish with
    | Repeats _ | At_state -> made
    | Stops -> last () :: made
    | Rests -> up_to None
    | Passes _ ->
      up_to
        (match Timed_graph.flow graph run.last with
         | Lasts (d, _) -> Some (Algebraic.of_rat d)
         | Forever | No_flow -> None)
    | During { sample; _ } when Algebraic.compare sample (after steps) <= 0 -> made
    | During { moment = { attained = true; _ }; sample } -> up_to (Some sample)
    | During { moment = { attained = false; _ }; sample } ->
      up_to (end_of_interval e formulas graph run.last sample)
  in
  let places = Array.of_list (List.rev made) in
  match run.finish with
  | Repeats k ->
    let rec first i = if places.(i).step = k then i else first (i + 1) in
    let again = first 0 in
    { run; places; again = Some again; period = Rat.sub clock places.(again).clock }
  | At_state | During _ | Rests | Stops | Passes _ -> { run; places; again = None; period = Rat.zero }

let within t (bound : Timed_formula.bound) =
  let start = t.run.start.offset in
  let low = Algebraic.add_rat bound.low start in
  let high =
    match t.again with None -> Option.map (fun h -> Algebraic.add_rat h start) bound.high | Some _ -> None
  in
  let counts i p =
    let at offset = Algebraic.add_rat p.clock offset in
    let recurs = match t.again with Some k -> i >= k && Rat.sign t.period > 0 | None -> false in
    let late_enough =
      match p.high with
      | None -> true
      | Some high ->
        let c = Algebraic.compare (at high) low in
        if is_interval p then c > 0 else c >= 0
    in
    let early_enough =
      match high with
      | None -> true
      | Some high ->
        let c = Algebraic.compare (at p.low) high in
        if is_interval p then c < 0 else c <= 0
    in
    recurs || (late_enough && early_enough)
  in
  let rec all i acc = if i < 0 then acc else all (i - 1) (if counts i t.places.(i) then i :: acc else acc) in
  all (Array.length t.places - 1) []

(** {2 The rest of a run} *)

type spot = { course : t; index : int; at : Positions.position }

(* The place of an index that counts on through the rounds, with the time at which it comes. *)
let unrolled t n =
  let size = Array.length t.places in
  if n < size then Some (n, t.places.(n).clock)
  else
    match t.again with
    | None -> None
    | Some k ->
      let round = size - k in
      let times = 1 + ((n - size) / round) in
      let i = k + ((n - size) mod round) in
      Some (i, Rat.add t.places.(i).clock (Rat.mul (Rat.of_int times) t.period))

let rec drop n l = match l with _ :: rest when n > 0 -> drop (n - 1) rest | _ -> l
let take n l = List.filteri (fun i _ -> i < n) l

let cycle t = match t.run.finish with Repeats k -> drop k t.run.steps | _ -> []

(* The steps from the place of an index to that of another, which counts on through the rounds. *)
let steps_between t i n =
  let from = t.places.(i).step in
  match unrolled t n with
  | None -> []
  | Some (j, _) when n < Array.length t.places -> take (t.places.(j).step - from) (drop from t.run.steps)
  | Some (j, _) ->
    let size = Array.length t.places in
    let k = match t.again with Some k -> k | None -> size in
    let whole = (n - size) / (size - k) in
    let round = cycle t in
    let rounds = List.concat (List.init whole (fun _ -> round)) in
    let more = List.append rounds (take (t.places.(j).step - t.places.(k).step) round) in
    List.append (drop from t.run.steps) more

let run_to t spot n (position : Positions.position) finish : Run.t =
  { start = spot.at; steps = steps_between t spot.index n; last = position.node; finish }

(* Without end, as the run of the course. *)
let run_on t spot : Run.t option =
  let from = t.places.(spot.index).step in
  let rest = drop from t.run.steps in
  let run steps finish : Run.t = { start = spot.at; steps; last = t.run.last; finish } in
  match t.run.finish with
  | Rests | Stops -> Some (run rest t.run.finish)
  | Repeats k when from < k || (from = k && not (Positions.is_inside spot.at)) ->
    Some (run rest (Repeats (k - from)))
  | Repeats _ -> Some (run (List.append rest (cycle t)) (Repeats (List.length rest)))
  | At_state | During _ | Passes _ -> None

(* Some rounds show what a run that repeats itself leads to; what needs more of them is left to a search. *)
let most_rounds = 4

let rat_max a = function Some b when Rat.compare b a > 0 -> b | Some _ | None -> a

(* The sets of "f until g" on the side that lets a run show it. *)
type sides = { f : Positions.t; g : Positions.t; low : Rat.t; high : Rat.t option; some : bool }

let finish_at (position : Positions.position) ~attained ~low : Run.finish =
  if not (Positions.is_inside position) then At_state
  else
    let offset = if attained then position.offset else low in
    During { moment = { offset; attained }; sample = position.offset }

(* What the next stretch of the way says: an instant, or an open interval, both in model time from the start of the
   course. *)
type said = Shown of Positions.position * Run.finish | Refuted | Past | Silent

(* A rational inside an interval of a flow that is within the window. *)
let inside_window s (place : place) clock =
  let low = Rat.sub s.low clock and high = Option.map (fun h -> Rat.sub h clock) s.high in
  let begins = if Algebraic.compare_rat place.low low < 0 then Algebraic.of_rat low else place.low in
  let ends =
    match (place.high, high) with
    | h, None -> h
    | None, Some h -> Some (Algebraic.of_rat h)
    | Some a, Some h -> if Algebraic.compare_rat a h <= 0 then Some a else Some (Algebraic.of_rat h)
  in
  let attained = Algebraic.compare begins place.low > 0 in
  let left_open = match place.high with Some a -> Algebraic.compare begins a >= 0 | None -> false in
  let late = match ends with Some e -> Algebraic.compare begins e > 0 | None -> false in
  let at_once = match ends with Some e -> Algebraic.equal begins e | None -> false in
  if left_open || late || (at_once && not attained) then None
  else if attained then Some (begins, true)
  else Some (Algebraic.of_rat (Pieces.inside begins ends), false)

let look s (place : place) clock ~at ~instant : said =
  let f = Positions.mem s.f at and g = Positions.mem s.g at in
  let now = Algebraic.add_rat clock at.offset in
  if instant then
    let late = match s.high with None -> false | Some h -> Algebraic.compare_rat now h > 0 in
    let counts = Algebraic.compare_rat now s.low >= 0 && not late in
    let shown = Shown (at, finish_at at ~attained:true ~low:at.offset) in
    if late then if s.some then Refuted else Past
    else if g && counts then if s.some then shown else Refuted
    else if f then Silent
    else if s.some then Refuted
    else shown
  else
    let beyond =
      match s.high with
      | None -> false
      | Some h -> (
          match place.high with
          | None -> true
          | Some e -> Algebraic.compare_rat (Algebraic.add_rat clock e) h > 0)
    in
    let shown (offset, attained) =
      let at = { at with Positions.offset } in
      Shown (at, finish_at at ~attained ~low:place.low)
    in
    (* As soon as f fails, whether or not g counts yet. *)
    let soon = if f then None else inside_window { s with low = clock } place clock in
    match (f, soon, if g then inside_window s place clock else None) with
    | false, Some there, _ -> if s.some then Refuted else shown there
    | true, _, Some there -> if s.some then shown there else Refuted
    | false, None, _ -> if s.some then Refuted else Past
    | true, _, None -> if beyond then if s.some then Refuted else Past else Silent

(* The place that a run comes to in each round and that shows by itself what is to come some time. *)
let recurring t s (u : Eval.until) =
  match (t.again, u.left, s.some && Option.is_none s.high && Rat.sign u.bound.low <= 0) with
  | Some k, And [], true ->
    let rec first test i =
      if i = Array.length t.places then None
      else if test t.places.(i) && Positions.mem s.g t.places.(i).position then Some i
      else first test (i + 1)
    in
    (match first (fun p -> not (is_interval p)) k with Some i -> Some i | None -> first is_interval k)
  | _ -> None

(* The numbers of places that are looked at, each round of a repeated course unrolled, at most. *)
let limit t =
  let size = Array.length t.places in
  match t.again with None -> size | Some k -> size + (most_rounds * (size - k))

(* True if a whole round was looked at of those that come when the time counts. *)
let whole_round_seen t s =
  match t.again with
  | None -> true
  | Some k -> (
      Rat.sign t.period = 0
      ||
      match unrolled t (limit t - (Array.length t.places - k)) with
      | Some (_, clock) -> Rat.compare clock s.low >= 0
      | None -> false)

(* What the place with this number of the course says: at its instant first, then after it. *)
let said s spot n i clock =
  let t = spot.course in
  let place = t.places.(i) in
  let on_from_here = n = spot.index in
  let at = if on_from_here then spot.at else place.position in
  let first =
    if on_from_here || not (is_interval place) then look s place clock ~at ~instant:true else Silent
  in
  let place = if on_from_here then { place with low = spot.at.offset } else place in
  match first with
  | Silent when is_interval t.places.(i) -> (at, look s place clock ~at ~instant:false)
  | said -> (at, said)

let follow e (u : Eval.until) spot =
  let t = spot.course in
  let here = t.places.(spot.index) in
  match (Algebraic.to_rat spot.at.offset, u.quantifier) with
  | None, _ | _, Chance _ -> None
  | Some offset, ((All | Exists) as quantifier) ->
    let start = Rat.add here.clock offset in
    let some = quantifier = Timed_formula.Exists in
    let side f = let v = Eval.value e f in if some then v.lower else v.upper in
    let s =
      { f = side u.left; g = side u.right; some; low = rat_max start (Some (Rat.add start u.bound.low));
        high = Option.map (Rat.add start) u.bound.high }
    in
    let limit = limit t and size = Array.length t.places in
    let reached n i position finish =
      let there = { course = t; index = i; at = position } in
      Some (run_to t spot n position finish, Some there)
    in
    let endless () =
      match (s.high, if some then None else run_on t spot) with
      | _, None -> None
      | Some _, Some { finish = Rests | Repeats _; _ } -> None
      | _, Some run -> Some (run, None)
    in
    let rec go n =
      match if n >= limit then None else unrolled t n with
      | None -> if whole_round_seen t s then endless () else None
      | Some (i, clock) -> (
          match said s spot n i clock with
          | _, Shown (position, finish) -> reached n i position finish
          | _, Refuted -> None
          | at, Past -> (
              match s.high with
              | Some h when Positions.is_inside at ->
                let left = Algebraic.of_rat (Rat.sub h clock) in
                Some (run_to t spot n at (Passes left), None)
              | Some _ | None -> None)
          | _, Silent -> go (n + 1))
    in
    (match recurring t s u with
     | Some goal when goal <> spot.index ->
       let n = if goal > spot.index then goal else goal + size - Option.value t.again ~default:size in
       let place = t.places.(goal) in
       let attained = not (is_interval place) in
       reached n goal place.position (finish_at place.position ~attained ~low:place.low)
     | _ -> go spot.index)
