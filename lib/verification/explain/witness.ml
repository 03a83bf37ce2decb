open Scc_exact
open Scc_calculus
open Scc_semantics

type step = { choice : int; transition : Transition.t; time : Rat.t }

type moved = Together of Vec.t | Apart of (int * Vec.t) list

type finish =
  | At_state
  | During of {
      choice : int option;
      offset : Algebraic.t;
      open_piece : bool;
      from : Algebraic.t;
    }
  | Rests of { puts_off : Transition.label option }
  | Stops
  | Repeats of { cycle : int; moved : moved; puts_off : Transition.label option }
  | Passes of { choice : int option; offset : Algebraic.t; shown : bool }
  | Goes_on of { cycle : int }

type argument = {
  where : string option;
  time : Rat.t option;
  claim : string;
  holds : bool;
  because : string list;
  parts : argument list;
}

let rec equal_arguments a b =
  Option.equal String.equal a.where b.where
  && Option.equal Rat.equal a.time b.time
  && String.equal a.claim b.claim
  && Bool.equal a.holds b.holds
  && List.equal String.equal a.because b.because
  && List.equal equal_arguments a.parts b.parts

type fixed = { values : (string * Rat.t) list; semantics : Semantics.t }

type t = {
  initial : State.t;
  steps : step list;
  last : State.t;
  finish : finish;
  facts : string list;
  argument : argument option;
  fixed : fixed option;
  otherwise : otherwise option;
}

and otherwise = { shared : int; run : t }

type halt = Dead_end | One_instant

let most_turns = Rat.of_int 1_000

let passes semantics ~choice offset (last : State.t) =
  let until = snd (Algebraic.enclose offset ~width:Rat.one) in
  let turns (p : State.process) =
    if Turn.spinning p then Rat.div until (Turn.length (Semantics.model semantics) p.spin) else Rat.zero
  in
  let all = Array.fold_left (fun n p -> Rat.add n (turns p)) Rat.zero last.processes in
  Passes { choice; offset; shown = Rat.compare all most_turns <= 0 }

let semantics given w = match w.fixed with Some f -> f.semantics | None -> given

(* Model time when the step of this index begins. *)
let time_before w k = if k = 0 then Rat.zero else (List.nth w.steps (k - 1)).time

let choices w = List.map (fun s -> s.choice) w.steps

let time w =
  match List.rev w.steps with [] -> Rat.zero | last :: _ -> last.time

let halt w =
  match w.finish with
  | Stops -> Some Dead_end
  | Repeats { cycle; _ } -> if Rat.equal (time_before w cycle) (time w) then Some One_instant else None
  | At_state | During _ | Rests _ | Passes _ | Goes_on _ -> None

let instant w =
  match w.finish with
  | During { offset; _ } | Passes { offset; shown = true; _ } -> Algebraic.add_rat (time w) offset
  | At_state | Rests _ | Stops | Repeats _ | Passes _ | Goes_on _ -> Algebraic.of_rat (time w)

let at_rational_instant w =
  match w.finish with
  | During { offset; _ } | Passes { offset; shown = true; _ } -> Option.is_some (Algebraic.to_rat offset)
  | At_state | Rests _ | Stops | Repeats _ | Passes _ | Goes_on _ -> true

let is_before_bound w = match w.finish with Passes { shown; _ } -> not shown | _ -> false

let offset w =
  match w.finish with
  | During { offset; _ } | Passes { offset; shown = true; _ } -> (
      match Algebraic.to_rat offset with
      | Some r -> Some r
      | None ->
        let width = Rat.make Z.one (Z.pow (Z.of_int 10) 12) in
        let low, high = Algebraic.enclose offset ~width in
        Some (Rat.middle low high))
  | At_state | Rests _ | Stops | Repeats _ | Passes _ | Goes_on _ -> None

let step_line model number s =
  Printf.sprintf "%d. %s, at time %s" (number + 1)
    (Transition.label_to_string model s.transition.label)
    (Rat.to_string s.time)

let there given w =
  let semantics = semantics given w in
  match offset w with
  | Some d when Rat.sign d > 0 -> Time.pass semantics d w.last
  | Some _ | None -> w.last

let during_line w ~offset ~open_piece ~from =
  let start = time w in
  let absolute t = Algebraic.to_string (Algebraic.add_rat start t) in
  if open_piece then
    Printf.sprintf "then time passes: right after time %s, for example at time %s" (absolute from)
      (absolute offset)
  else Printf.sprintf "then time passes, until time %s" (absolute offset)

let put_off model label =
  let reason label =
    Printf.sprintf "it puts off %s for ever: no fairness is assumed" (Transition.label_to_string model label)
  in
  Option.to_list (Option.map reason label)

let moved_text (model : Model.t) = function
  | Together by when Vec.is_zero by -> ""
  | Together by -> Printf.sprintf ", each time with everything moved by %s" (Vec.to_string by)
  | Apart all ->
    let told (leaf, by) =
      if Vec.is_zero by then None
      else Some (Printf.sprintf "%s moved by %s" model.leaves.(leaf).name (Vec.to_string by))
    in
    ", each time with " ^ String.concat ", " (List.filter_map told all)

let finish_lines model w =
  match w.finish with
  | At_state -> ( match w.steps with [] -> [ "in the initial state" ] | _ :: _ -> [])
  | During { offset; open_piece; from; _ } -> [ during_line w ~offset ~open_piece ~from ]
  | Rests { puts_off } ->
    "then nothing happens any more, and time passes for ever" :: put_off model puts_off
  | Goes_on { cycle } ->
    [
      Printf.sprintf
        "then it goes on for ever, which is known of sets of states: this one is like that before step %d, but \
         for numbers, and no run was found that comes back to a state"
        (cycle + 1);
    ]
  | Stops -> [ "then the run ends: neither time nor anything else can go on, and the model is given up there" ]
  | Passes { offset; shown; _ } ->
    let bound = Algebraic.to_string (Algebraic.add_rat (time w) offset) in
    let too_far = if shown then "" else "; until then bodies turn too often for the state there to be shown" in
    [ Printf.sprintf "then time passes beyond the bound, which ends at time %s%s" bound too_far ]
  | Repeats { cycle; moved; puts_off } ->
    let again =
      if cycle + 1 = List.length w.steps then Printf.sprintf "and step %d again, for ever" (cycle + 1)
      else Printf.sprintf "and the steps from %d on again, for ever" (cycle + 1)
    in
    (again ^ moved_text model moved) :: put_off model puts_off

let rec argument_lines depth a =
  let indented text = String.make (2 * depth) ' ' ^ text in
  let verb = if a.holds then " holds" else " does not hold" in
  let because = match a.because with [] -> [ "" ] | because -> because in
  let claim = match a.where with None -> a.claim | Some where -> where ^ ", " ^ a.claim in
  let line i text =
    if i > 0 then indented ("  " ^ text)
    else if String.equal text "" then indented (claim ^ verb)
    else indented (claim ^ verb ^ ": " ^ text)
  in
  List.mapi line because @ List.concat_map (argument_lines (depth + 1)) a.parts

let ending model w =
  finish_lines model w @ w.facts
  @ match w.argument with None -> [] | Some a -> "why:" :: argument_lines 1 a

let lines model w =
  List.(append (mapi (step_line model) w.steps) (ending model w))
