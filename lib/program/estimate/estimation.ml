open Scc_exact
open Scc_property
open Scc_chance

type size = Exactly of int | At_most of int
type aim = { confidence : Rat.t; width : Rat.t; size : size; free : Sample.free }

type value =
  | Probability of Rat.t * Rat.t
  | Mean of { mean : Rat.t option; low : Rat.t; high : Rat.t }
  | Sample of { mean : Rat.t; deviation : Rat.t option }
  | Infinite
  | Unknown

type verdict = Estimated | Sampled | Holds | Violated | Undecided

type answer = {
  path : Path.t;
  verdict : verdict;
  value : value;
  tally : Tally.t;
  chosen : bool;
  reasons : string list;
}

type question = {
  asked : Path.t;
  mutable tally : Tally.t;
  mutable left_out : int;  (** runs that were interrupted, and are not in the tally *)
  mutable answer : answer option;  (** when it is settled *)
}

type t = { aim : aim; questions : question list; mutable looks : int; mutable runs : int; mutable chosen : bool }

let first_size = 128

let start aim paths =
  let question path = { asked = path; tally = Tally.empty; left_out = 0; answer = None } in
  { aim; questions = List.map question paths; looks = 0; runs = 0; chosen = false }

let settled t = List.for_all (fun q -> Option.is_some q.answer) t.questions

let next t =
  if settled t then None
  else
    match t.aim.size with
    | Exactly n -> Some n
    | At_most n -> Some (Int.min n (if t.runs = 0 then first_size else t.runs + (t.runs / 2)))

(* Of a number without a known range nothing is known where a run is open, and nothing is proved by the others: a
   run that was interrupted is left out. *)
let add_outcome q (o : Sample.outcome) =
  match (q.asked.question, o) with
  | Amounts (_, None), Too_long Interruption -> q.left_out <- q.left_out + 1
  | (Amounts _ | Does), _ -> q.tally <- Tally.add q.tally o

let add t (r : Sample.run) =
  t.runs <- t.runs + 1;
  if r.chosen then t.chosen <- true;
  List.iter2 (fun q o -> if Option.is_none q.answer then add_outcome q o) t.questions r.outcomes

(* {1 One look} *)

let miss t =
  let all = Rat.sub Rat.one t.aim.confidence in
  match t.aim.size with
  | Exactly _ -> all
  | At_most _ -> Rat.div all (Rat.of_int (t.looks * (t.looks + 1)))

(* No run tells anything, and there is nothing to count. *)
let all_open (tally : Tally.t) = Tally.open_ended tally = tally.runs

let value q miss =
  match q.asked.question with
  | Does when all_open q.tally -> Unknown
  | Amounts (_, Some range) when all_open q.tally && not (Rat.equal range.low range.high) -> Unknown
  | Does ->
    let low, high = Tally.likelihood q.tally ~miss in
    Probability (low, high)
  | Amounts _ when q.tally.never > 0 -> Infinite
  | Amounts _ when q.tally.no_value > 0 -> Unknown
  | Amounts (_, Some range) ->
    let low, high = Tally.mean q.tally range ~miss in
    let mean = if Tally.open_ended q.tally > 0 then None else Option.map fst (Tally.spread q.tally) in
    Mean { mean; low; high }
  | Amounts (_, None) when Tally.open_ended q.tally > 0 -> Unknown
  | Amounts (_, None) -> (
      match Tally.spread q.tally with
      | Some (mean, deviation) -> Sample { mean; deviation }
      | None -> Unknown)

let range q =
  match q.asked.question with
  | Amounts (_, range) -> range
  | Does -> Some { low = Rat.zero; high = Rat.one; ends_only = true }

(* What is known of what the test is about. Where choices have been taken evenly the least is not more than what
   was found, and the greatest not less. *)
let known t q (side : Property.side) value : Answer.t option =
  match value with
  | Probability (low, high) | Mean { low; high; _ } -> (
      match (t.chosen, side, range q) with
      | true, Least, Some range -> Some (Within (range.low, high))
      | true, Greatest, Some range -> Some (Within (low, range.high))
      | _, _, _ -> Some (Within (low, high)))
  | Infinite when (not t.chosen) || side = Greatest -> Some Infinite
  | Infinite | Sample _ | Unknown -> None

(* How wide the interval may be. *)
let allowed t value =
  match value with
  | Mean { mean; low; high } ->
    let about = match mean with Some mean -> Rat.abs mean | None -> Rat.max (Rat.abs low) (Rat.abs high) in
    Rat.mul t.aim.width about
  | Probability _ | Sample _ | Infinite | Unknown -> t.aim.width

let is_narrow t value =
  match value with
  | Probability (low, high) | Mean { low; high; _ } -> Rat.compare (Rat.sub high low) (allowed t value) <= 0
  | Infinite -> true
  | Sample _ | Unknown -> false

(* However many runs there are, they do not tell it: no range is known, or what stays open is already too much. *)
let is_hopeless t q ~miss value =
  let n = q.tally.runs and k = Tally.open_ended q.tally in
  match (value, range q) with
  | (Probability _ | Mean _), Some range when k > 0 ->
    let share = Clopper_pearson.lower ~n ~k ~miss:(Rat.mul Rat.half miss) in
    Rat.compare (Rat.mul share (Rat.sub range.high range.low)) (allowed t value) > 0
  | (Probability _ | Mean _), _ -> false
  | Infinite, _ -> k > 0
  | (Sample _ | Unknown), _ -> true

let of_runs (tally : Tally.t) k = Printf.sprintf "%d of %d runs" k tally.runs

let of_bound : Sample.bound -> string = function
  | Steps -> "--steps"
  | Time -> "--until"
  | Instant -> "many transitions happen without time passing"
  | Interruption -> "the command was stopped"

let open_reasons { tally; left_out; _ } =
  List.concat
    [
      (match left_out with
       | 0 -> []
       | 1 -> [ "1 more run is left out, which was interrupted" ]
       | n -> [ Printf.sprintf "%d more runs are left out, which were interrupted" n ]);
      (if tally.free = 0 then []
       else
         [ of_runs tally tally.free
           ^ " depend on choices that nothing draws: where these are orders of collisions, `collisions drawn` in \
              the model draws them; "
           ^ (if tally.bounces = 0 then "" else "`blocked wait` leaves none where walkers bounce; ")
           ^ "`--free evenly` takes each choice as often; and `scc check` tells the least and the greatest" ]);
      (if tally.too_long = 0 then []
       else [ of_runs tally tally.too_long ^ " were left before it was known: "
              ^ String.concat ", " (List.map of_bound tally.bounds) ]);
      (match tally.why with
       | None -> []
       | Some why -> [ Printf.sprintf "%s do not tell: %s" (of_runs tally tally.no_value) why ]);
    ]

let asked_for t value =
  match (value, t.aim.size) with
  | Sample _, _ ->
    "no range of this number is known, and so no interval: a value too rare to be among the runs may move the \
     mean by any amount. `scc check` tells the mean where it gets to the end"
  | Unknown, _ -> "no run was made"
  | _, Exactly _ -> "more runs would tell more"
  | _, At_most n when t.runs >= n -> Printf.sprintf "more than %d runs are needed: --most" n
  | _, At_most _ -> "more runs would tell more"

let answer t q value verdict ~reasons =
  { path = q.asked; verdict; value; tally = q.tally; chosen = t.chosen; reasons }

let look t q ~miss ~last =
  let value = value q miss in
  let narrow = is_narrow t value and hopeless = is_hopeless t q ~miss value in
  let wide () =
    let still_open = open_reasons q in
    match value with
    | _ when narrow -> []
    | Unknown when still_open <> [] -> still_open
    | Probability _ | Mean _ | Infinite when hopeless -> still_open
    | Probability _ | Mean _ | Infinite | Sample _ | Unknown -> still_open @ [ asked_for t value ]
  in
  let settle verdict ~reasons = q.answer <- Some (answer t q value verdict ~reasons) in
  match Path.test q.asked with
  | None ->
    let fixed = match t.aim.size with Exactly _ -> true | At_most _ -> false in
    if narrow || hopeless || last then (
      match value with
      | Sample _ -> settle Sampled ~reasons:(wide ())
      | Unknown -> settle Undecided ~reasons:(wide ())
      | Probability _ | Mean _ | Infinite ->
        settle Estimated ~reasons:(if fixed && not hopeless then open_reasons q else wide ()))
  | Some (side, test) -> (
      match Option.bind (known t q side value) (fun known -> Answer.holds known test) with
      | Some holds -> settle (if holds then Holds else Violated) ~reasons:[]
      | None ->
        let even =
          if t.chosen then [ "choices that nothing draws were taken evenly, which the bound is not about" ] else []
        in
        if narrow then settle Undecided ~reasons:(even @ [ "the bound is within the interval" ])
        else if hopeless || last then settle Undecided ~reasons:(even @ wide ()))

let judge t ~last =
  t.looks <- t.looks + 1;
  let full = match next t with Some n -> t.runs >= n | None -> true in
  let at_end = last || match t.aim.size with Exactly _ -> true | At_most n -> full && t.runs >= n in
  let miss = miss t in
  List.iter (fun q -> if Option.is_none q.answer then look t q ~miss ~last:at_end) t.questions

let answers t = List.filter_map (fun q -> q.answer) t.questions
