open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_motion
open Scc_explain

let greatest_list = 40
let name (m : Model.t) leaf = m.leaves.(leaf).name

let aspect m (r : Causes.reason) =
  let of_leaf what = Printf.sprintf "%s of %s" what (name m r.leaf) in
  match r.aspect with
  | Motion -> Some (of_leaf "motion")
  | Structure -> Some (of_leaf "bonds")
  | Behaviour -> Some (of_leaf "behaviour")
  | Clock -> Some (of_leaf "split clock")
  | Itself -> None

(* Reasons come sorted by cause; those of one step are told together. *)
let reasons m (events : Causes.event array) list =
  let add groups (r : Causes.reason) =
    let step = events.(r.cause).step and what = Option.to_list (aspect m r) in
    match groups with
    | (s, words) :: rest when s = step -> (s, words @ what) :: rest
    | _ -> (step, what) :: groups
  in
  let group (step, words) =
    match words with
    | [] -> Printf.sprintf "step %d" (step + 1)
    | _ -> Printf.sprintf "step %d (%s)" (step + 1) (String.concat ", " words)
  in
  match List.rev (List.fold_left add [] list) with
  | [] -> "how everything started"
  | groups -> String.concat ", " (List.map group groups)

let listed words =
  let n = List.length words in
  if n > greatest_list then
    let shown = List.filteri (fun i _ -> i < greatest_list) words in
    Printf.sprintf "%s and %d more" (String.concat ", " shown) (n - greatest_list)
  else
    match List.rev words with
    | [] -> "nothing"
    | [ w ] -> w
    | last :: first -> String.concat ", " (List.rev first) ^ " and " ^ last

let body m leaves = String.concat "+" (List.map (name m) leaves)

let matters = function
  | Omission.Irrelevant -> false
  | Cause | Keeps_away -> true

let shown_facts ~full (x : Omission.t) =
  let n = List.length x.facts in
  let shown = List.filteri (fun i _ -> full || i < greatest_list) x.facts in
  if n > greatest_list && not full then shown @ [ Printf.sprintf "and %d more" (n - greatest_list) ] else shown

let heading console ~full check (x : Omission.t) =
  let m = Causes.model x.story and events = Causes.events x.story in
  let strong = Console.styled console Console.Strong in
  let about =
    match check with
    | Some (c : Property.check) -> Printf.sprintf "%s: %s" (strong c.name) c.text
    | None -> strong "the last event"
  in
  let because =
    match (x.basis.reasons, check) with
    | [], None -> "nothing has happened"
    | list, _ -> "because of " ^ reasons m events list
  in
  let facts =
    match shown_facts ~full x with
    | [] -> []
    | facts ->
      Printf.sprintf "at time %s:" (Run_text.number ~full (Causes.duration x.story))
      :: List.map (fun f -> "  " ^ if full then f else Scc_runs.Short_text.within f) facts
  in
  (about :: facts) @ [ because; "" ]

(* Events of one step, and those of them that matter. *)
let relevant (x : Omission.t) = List.filter (fun i -> matters x.roles.(i))

let step_lines ~full (x : Omission.t) of_step number label time =
  let m = Causes.model x.story and events = Causes.events x.story in
  let relevant = relevant x of_step in
  let why i =
    let e = events.(i) in
    let keeps =
      match x.roles.(i) with
      | Keeps_away -> "keeps bodies out of the way; "
      | Irrelevant | Cause -> ""
    in
    let subject =
      match e.happening with
      | Discrete _ -> ""
      | Expiry leaf -> Printf.sprintf "a delay of %s is over, " (name m leaf)
    in
    Printf.sprintf "         %s%sbecause of %s" keeps subject (reasons m events e.reasons)
  in
  let mark = match relevant with [] -> " " | _ :: _ -> "*" in
  Printf.sprintf "%s %4d. %s, at time %s" mark number (Run_text.label ~full m label) (Run_text.number ~full time)
  :: List.map why relevant

(* Steps in which nothing happens that matters, in one line. *)
let beside (x : Omission.t) of_step (legs : Course.leg array) first last =
  let m = Causes.model x.story and events = Causes.events x.story in
  let steps = List.init (last - first + 1) (fun k -> first + k) in
  let happened = List.filter (fun i -> not (Transition.is_time legs.(i).label)) steps in
  let leaves_of i = List.concat_map (fun e -> events.(e).Causes.leaves) of_step.(i) in
  let bodies = List.map (name m) (List.sort_uniq Int.compare (List.concat_map leaves_of happened)) in
  let what =
    match happened with
    | [] -> "time passes"
    | [ _ ] -> Printf.sprintf "one event that does not matter (of %s)" (listed bodies)
    | _ -> Printf.sprintf "%d events that do not matter (of %s)" (List.length happened) (listed bodies)
  in
  let leg = legs.(last) in
  let time = Rat.add leg.start (Transition.duration_of leg.label) in
  Printf.sprintf "  %s. %s, to time %s"
    (Printf.sprintf "%4s" (Printf.sprintf "%d-%d" (first + 1) (last + 1)))
    what (Run_text.number ~full:false time)

let steps ~full (x : Omission.t) =
  let legs = Course.legs (Causes.run x.story).course in
  let n = Array.length legs in
  let of_step = Array.make n [] in
  Array.iteri (fun i (e : Causes.event) -> of_step.(e.step) <- i :: of_step.(e.step)) (Causes.events x.story);
  let matters i = match relevant x of_step.(i) with [] -> false | _ :: _ -> true in
  let line i =
    let { label; start; _ } : Course.leg = legs.(i) in
    step_lines ~full x (List.rev of_step.(i)) (i + 1) label (Rat.add start (Transition.duration_of label))
  in
  let rec last_beside i = if i + 1 < n && not (matters (i + 1)) then last_beside (i + 1) else i in
  let rec go i acc =
    if i >= n then List.rev acc
    else
      let last = if full || matters i then i else last_beside i in
      go (last + 1) ((if last = i then line i else [ beside x of_step legs i last ]) :: acc)
  in
  List.concat (go 0 [])

(* How many of the transitions other than passings of time matter. *)
let counted (x : Omission.t) =
  let count (relevant, all) role (e : Causes.event) =
    match e.happening with
    | Expiry _ -> (relevant, all)
    | Discrete _ -> ((if matters role then relevant + 1 else relevant), all + 1)
  in
  let roles = Array.to_list x.roles and events = Array.to_list (Causes.events x.story) in
  let relevant, all = List.fold_left2 count (0, 0) roles events in
  Printf.sprintf "%d of %d events matter" relevant all

let conclusion (x : Omission.t) =
  let m = Causes.model x.story in
  let keeps (leaves, why) =
    Printf.sprintf "%s matters by what it keeps away: without it, %s" (body m leaves) why
  in
  let tried =
    match x.left_out with
    | [] -> "every body takes part: none could be left out to try"
    | list -> Printf.sprintf "checked: the same happens without %s" (listed (List.map (body m) list))
  in
  (counted x :: List.map keeps x.keep_away) @ [ tried ]

let dead_end m (ending : Scc_runs.Replay.ending) =
  match ending with
  | Stuck { fault; _ } ->
    [ "       the run ends here, in a dead end: " ^ (Transition.diagnostic m fault).message ]
  | Open | Quiescent | Zeno | Broken_off -> []

let lines console ~full check ending x =
  let over = dead_end (Causes.model x.Omission.story) ending in
  String.concat "\n" (heading console ~full check x @ steps ~full x @ over @ ("" :: conclusion x)) ^ "\n"
