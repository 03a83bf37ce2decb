open Scc_exact
open Scc_property
open Scc_chance

type size = Exactly of int | At_most of int
type aim = { confidence : Rat.t; width : Rat.t; size : size; free : Sample.free; normal : bool }

type value =
  | Probability of Rat.t * Rat.t
  | Mean of { mean : Rat.t option; low : Rat.t option; high : Rat.t option }
  | Approximate of { mean : Rat.t; low : Rat.t; high : Rat.t }
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
  splitting : Splitting.summary option;
}

type question = {
  asked : Path.t;
  mutable tally : Tally.t;
  mutable left_out : int;  (** runs that were interrupted, and are not in the tally *)
  mutable low : Rat.t option;  (** the greatest lower end of the looks so far *)
  mutable high : Rat.t option;  (** the least upper end *)
  mutable answer : answer option;  (** when it is settled *)
}

type t = { aim : aim; questions : question list; mutable looks : int; mutable runs : int; mutable chosen : bool }

let first_size = 128

let start aim paths =
  let question asked =
    { asked; tally = Tally.empty; left_out = 0; low = None; high = None; answer = None }
  in
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
  | Amounts (_, range), Too_long Interruption when Range.is_unknown range -> q.left_out <- q.left_out + 1
  | (Amounts _ | Does), _ -> q.tally <- Tally.add q.tally o

let add t (r : Sample.run) =
  t.runs <- t.runs + 1;
  if r.chosen then t.chosen <- true;
  List.iter2 (fun q o -> if Option.is_none q.answer then add_outcome q o) t.questions r.outcomes

(* {1 One look} *)

let miss t = Rat.sub Rat.one t.aim.confidence

(* The share of this look. *)
let share t =
  match t.aim.size with
  | Exactly _ -> miss t
  | At_most _ -> Rat.div (miss t) (Rat.of_int (t.looks * (t.looks + 1)))

(* No run tells anything, and there is nothing to count. *)
let all_open (tally : Tally.t) = Tally.open_ended tally = tally.runs

let range q : Range.t =
  match q.asked.question with
  | Amounts (_, range) -> range
  | Does -> { low = Some Rat.zero; high = Some Rat.one; ends_only = true }

let is_constant (range : Range.t) =
  match Range.both range with Some (low, high) -> Rat.equal low high | None -> false

(* All looks are right with the confidence, so that the answer is what they have in common. If they have nothing in
   common one of them is wrong, and there is no better answer than the last. *)
let in_common q (low, high) =
  let low' = Option.merge Rat.max q.low low and high' = Option.merge Rat.min q.high high in
  match (low', high') with
  | Some l, Some h when Rat.compare l h > 0 -> (low, high)
  | _ ->
    q.low <- low';
    q.high <- high';
    (low', high')

(* Where an end is missing that would be proved. Runs that are left out are the long ones: without them the mean of
   the others is another one. *)
let approximated t q range =
  t.aim.normal && Range.both range = None && Tally.open_ended q.tally = 0 && q.left_out = 0
  && Normal_mean.others q.tally >= Normal_mean.needed

let approximate q (range : Range.t) ~look =
  match Normal_mean.interval q.tally ~miss:look with
  | None -> Unknown
  | Some (mean, error) ->
    let low = Option.fold ~none:Fun.id ~some:Rat.max range.low (Rat.sub mean error) in
    let high = Option.fold ~none:Fun.id ~some:Rat.min range.high (Rat.add mean error) in
    Approximate { mean; low; high }

let value t q =
  let look = share t and open_ended = Tally.open_ended q.tally in
  match q.asked.question with
  | (Does | Amounts _) when all_open q.tally && not (is_constant (range q)) -> Unknown
  | Does ->
    let low, high = Tally.likelihood q.tally ~miss:look in
    let known = function Some x, Some y -> (x, y) | _ -> (low, high) in
    let low, high = known (in_common q (Some low, Some high)) in
    Probability (low, high)
  | Amounts _ when q.tally.never > 0 -> Infinite
  | Amounts _ when q.tally.no_value > 0 -> Unknown
  | Amounts (_, range) when approximated t q range -> approximate q range ~look
  | Amounts (_, range) when not (Range.is_unknown range) ->
    let low, high = in_common q (Tally.mean q.tally range ~look ~miss:(miss t)) in
    let mean = if open_ended > 0 then None else Option.map fst (Tally.spread q.tally) in
    Mean { mean; low; high }
  | Amounts _ when open_ended > 0 -> Unknown
  | Amounts _ -> (
      match Tally.spread q.tally with
      | Some (mean, deviation) -> Sample { mean; deviation }
      | None -> Unknown)

(* What is known of what the test is about. Where choices have been taken evenly the least is not more than what
   was found, and the greatest not less. Without an end, the number may be on either side of the bound. *)
let known t q (side : Property.side) (test : Answer.bound) value : Answer.t option =
  let within low high : Answer.t option =
    let beyond other step = Rat.add (Option.fold ~none:test.than ~some:(fun x -> other x test.than) step) in
    let low' = Option.value low ~default:(beyond Rat.min high (Rat.of_int (-1))) in
    let high' = Option.value high ~default:(beyond Rat.max low Rat.one) in
    Some (Within (low', high'))
  in
  let sided low high =
    match (t.chosen, side) with
    | true, Least -> within (range q).low high
    | true, Greatest -> within low (range q).high
    | false, _ -> within low high
  in
  match value with
  | Probability (low, high) -> sided (Some low) (Some high)
  | Mean { low; high; _ } -> sided low high
  | Approximate { low; high; _ } -> sided (Some low) (Some high)
  | Infinite when (not t.chosen) || side = Greatest -> Some Infinite
  | Infinite | Sample _ | Unknown -> None

(* How far the ends of the interval are apart; with one end, twice its distance from the mean of the runs. *)
let extent q value =
  let around (range : Range.t) x =
    let opens = Rat.of_int (Tally.open_ended q.tally) in
    let sum = Rat.add q.tally.sum (Rat.mul opens (Option.get (Option.merge Rat.min range.low range.high))) in
    let mean = Rat.div sum (Rat.of_int q.tally.runs) in
    Rat.mul (Rat.of_int 2) (Rat.abs (Rat.sub mean x))
  in
  match value with
  | Probability (low, high) | Mean { low = Some low; high = Some high; _ } | Approximate { low; high; _ } ->
    Some (Rat.sub high low)
  | Mean { low = Some x; high = None; _ } | Mean { low = None; high = Some x; _ } -> Some (around (range q) x)
  | Mean { low = None; high = None; _ } | Sample _ | Infinite | Unknown -> None

(* How wide the interval may be. *)
let allowed t value =
  match value with
  | Mean { mean = Some about; _ } | Approximate { mean = about; _ } -> Rat.mul t.aim.width (Rat.abs about)
  | Mean { mean = None; low; high } ->
    let size = Option.fold ~none:Rat.zero ~some:Rat.abs in
    Rat.mul t.aim.width (Rat.max (size low) (size high))
  | Probability _ | Sample _ | Infinite | Unknown -> t.aim.width

let is_narrow t q value =
  match (value, extent q value) with
  | Infinite, _ -> true
  | Mean _, _ when t.aim.normal && Range.both (range q) = None -> false
  | _, Some extent -> Rat.compare extent (allowed t value) <= 0
  | _, None -> false

(* However many runs there are, they do not tell it: no range is known, or what stays open is already too much. *)
let is_hopeless t q value =
  let n = q.tally.runs and k = Tally.open_ended q.tally in
  match (value, Range.both (range q)) with
  | (Probability _ | Mean _), Some (low, high) when k > 0 ->
    let share = Clopper_pearson.lower ~n ~k ~miss:(Rat.mul Rat.half (share t)) in
    Rat.compare (Rat.mul share (Rat.sub high low)) (allowed t value) > 0
  | (Probability _ | Mean _ | Approximate _), _ -> false
  | Sample _, _ when t.aim.normal -> false
  | Infinite, _ -> k > 0
  | (Sample _ | Unknown), _ -> true

let of_runs (tally : Tally.t) k ~one ~many =
  Printf.sprintf "%d of %s %s" k (Scc_base.Plural.count tally.runs "run" "runs") (if k = 1 then one else many)

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
         [ of_runs tally tally.free ~one:"depends" ~many:"depend"
           ^ " on choices that nothing draws: "
           ^ (if tally.free = tally.splits then ""
              else "where these are orders of collisions, `collisions drawn` in the model draws them; ")
           ^ (if tally.splits = 0 then ""
              else "where these are weak splits, a `rate` or a `chance` of the split draws them; ")
           ^ (if tally.bounces = 0 then "" else "`blocked wait` leaves none where walkers bounce; ")
           ^ "`--free evenly` takes each choice as often; and `scc check` tells the least and the greatest" ]);
      (if tally.too_long = 0 then []
       else [ of_runs tally tally.too_long ~one:"was" ~many:"were" ^ " left before it was known: "
              ^ String.concat ", " (List.map of_bound tally.bounds) ]);
      (match tally.why with
       | None -> []
       | Some why -> [ of_runs tally tally.no_value ~one:"does" ~many:"do" ^ " not tell: " ^ why ]);
    ]

let too_alike q =
  Printf.sprintf "%d runs have another value than the most frequent one: --normal needs %d of them"
    (Normal_mean.others q.tally) Normal_mean.needed

(* The end that is missing, whatever the number of runs. *)
let one_sided t q value =
  let no end_ moves =
    [
      Printf.sprintf
        "no %s value of this number is known, and so no %s end: a value too rare to be among the runs may %s the \
         mean by any amount"
        (fst end_) (snd end_) moves;
    ]
  in
  match value with
  | Mean { low = None; _ } | Mean { high = None; _ }
    when t.aim.normal && Tally.open_ended q.tally = 0 ->
    [ too_alike q ]
  | Mean { high = None; _ } -> no ("greatest", "upper") "raise"
  | Mean { low = None; _ } -> no ("least", "lower") "lower"
  | Mean _ | Approximate _ | Probability _ | Sample _ | Infinite | Unknown -> []

(* A bound that only a probability of 0 or 1 meets: an interval of runs that has one of them has others, too. *)
let never_holds q =
  match Path.test q.asked with
  | Some (_, { relation = At_least_so; than }) -> Rat.compare than Rat.one >= 0
  | Some (_, { relation = At_most; than }) -> Rat.sign than <= 0
  | Some (_, { relation = Less | More; _ }) | None -> false

let asked_for t q value =
  match (value, t.aim.size) with
  | Sample _, _ when t.aim.normal && q.left_out = 0 -> [ too_alike q ]
  | Sample _, _ ->
    [
      "no range of this number is known, and so no interval: a value too rare to be among the runs may move the \
       mean by any amount. `scc check` tells the mean where it gets to the end";
      Cure.within_bounds;
    ]
  | Unknown, _ -> [ "no run was made: it was stopped before; runs of questions that a time decides come first" ]
  | Probability _, _ when never_holds q ->
    [ "runs can refute this bound, and never confirm it: no probability is beyond it" ]
  | _, At_most n when t.runs >= n -> [ Printf.sprintf "more than %d runs are needed: --most" n ]
  | _, (Exactly _ | At_most _) -> [ "more runs would tell more" ]

let answer t q value verdict ~reasons =
  { path = q.asked; verdict; value; tally = q.tally; chosen = t.chosen; reasons; splitting = None }

let look t q ~last =
  let value = value t q in
  let narrow = is_narrow t q value and hopeless = is_hopeless t q value in
  let wide () =
    let still_open = open_reasons q in
    match value with
    | _ when narrow -> []
    | Unknown when still_open <> [] -> still_open
    | Probability _ | Mean _ | Approximate _ | Infinite when hopeless -> still_open
    | Probability _ | Mean _ | Approximate _ | Infinite | Sample _ | Unknown -> still_open @ asked_for t q value
  in
  let settle verdict ~reasons = q.answer <- Some (answer t q value verdict ~reasons) in
  match Path.test q.asked with
  | None ->
    let fixed = match t.aim.size with Exactly _ -> true | At_most _ -> false in
    if narrow || hopeless || last then (
      match value with
      | Sample _ -> settle Sampled ~reasons:(wide ())
      | Unknown -> settle Undecided ~reasons:(wide ())
      | Probability _ | Mean _ | Approximate _ | Infinite ->
        let reasons = if fixed && not hopeless then open_reasons q else wide () in
        settle Estimated ~reasons:(one_sided t q value @ reasons))
  | Some (side, test) -> (
      match Option.bind (known t q side test value) (fun known -> Answer.holds known test) with
      | Some holds -> settle (if holds then Holds else Violated) ~reasons:[]
      | None ->
        let even =
          if t.chosen then [ "choices that nothing draws were taken evenly, which the bound is not about" ] else []
        in
        let within =
          match one_sided t q value with
          | [] when never_holds q -> asked_for t q value
          | [] -> [ "the bound is within the interval" ]
          | some -> some
        in
        if narrow then settle Undecided ~reasons:(even @ within)
        else if hopeless || last then settle Undecided ~reasons:(even @ one_sided t q value @ wide ()))

let judge t ~last =
  t.looks <- t.looks + 1;
  let full = match next t with Some n -> t.runs >= n | None -> true in
  let at_end = last || match t.aim.size with Exactly _ -> true | At_most n -> full && t.runs >= n in
  List.iter (fun q -> if Option.is_none q.answer then look t q ~last:at_end) t.questions

(* {1 Rare events} *)

let of_splitting path (s : Splitting.summary) =
  let answer verdict reasons =
    let tally = { Tally.empty with runs = s.repetitions } in
    { path; verdict; value = Probability (s.low, s.high); tally; chosen = false; reasons; splitting = Some s }
  in
  let left =
    if s.left = 0 then []
    else
      [
        Printf.sprintf
          "%d runs between levels were left, by --steps, at a choice that nothing draws, or where it is not known \
           whether f holds: what comes after is not counted, and there is no upper end"
          s.left;
      ]
  in
  let last = List.length s.shares in
  let at_level i (passed, all) =
    let goal = i + 1 = last in
    if passed = 0 && all > 0 then
      [
        Printf.sprintf "no run passed %s, of %d from %s"
          (if goal then "on to the goal" else Printf.sprintf "level %d" (i + 1))
          all
          (if i = 0 then "the start" else Printf.sprintf "level %d" i);
      ]
    else if passed = all && all > 0 && not goal then
      [ Printf.sprintf "all runs passed level %d: it can be left out" (i + 1) ]
    else if passed = all && all > 0 && i > 0 then
      [ Printf.sprintf "all runs from level %d came to the goal: the level can be left out, or be a lower one" i ]
    else []
  in
  let reasons = left @ List.concat (List.mapi at_level s.shares) in
  match Path.test path with
  | None -> answer Estimated reasons
  | Some (_, test) -> (
      match Answer.holds (Within (s.low, s.high)) test with
      | Some holds -> answer (if holds then Holds else Violated) []
      | None -> answer Undecided (reasons @ [ "the bound is within the interval" ]))

let answers t = List.filter_map (fun q -> q.answer) t.questions
