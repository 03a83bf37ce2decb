open Scc_exact
open Scc_property

(* Constants are worked out: they stand alone or not at all. *)
type asked = Constant of bool | Asked of string

let text = function Constant b -> string_of_bool b | Asked s -> s
let bracket f = "(" ^ text f ^ ")"

let not_ = function
  | Constant b -> Constant (not b)
  | Asked s -> Asked (Printf.sprintf "!(%s)" s)

(* [neutral] changes nothing, and its complement decides. *)
let several operator ~neutral parts =
  let is b = function Constant c -> Bool.equal b c | Asked _ -> false in
  if List.exists (is (not neutral)) parts then Constant (not neutral)
  else
    match List.filter (fun f -> not (is neutral f)) parts with
    | [] -> Constant neutral
    | [ f ] -> f
    | parts -> Asked (String.concat operator (List.map bracket parts))

let both f g = several " & " ~neutral:true [ f; g ]
let either f g = several " | " ~neutral:false [ f; g ]

type labels = { predicates : State_predicates.t array; occurs : string -> bool; draws : bool }

let label l name = if l.occurs name then Asked (Printf.sprintf "\"%s\"" name) else Constant false

let state l (p : Property.prop) =
  let same (q : State_predicates.t) = Formula.equal_prop q.prop p in
  match p with
  | Bool b -> Ok (Constant b)
  | _ -> (
      match List.find_opt same (Array.to_list l.predicates) with
      | Some q -> Ok (label l q.name)
      | None -> Error "it speaks of events")

let unbounded (b : Property.bound) =
  if Rat.sign b.low = 0 && Option.is_none b.high then Ok () else Error "it has a bound of time"

(* Whether some first steps of a run show that it does so, or that it does not. *)
type shown = By_a_prefix | By_its_absence

(* Without a word for it, "P >= p" is meant of all schedulers. *)
let compared measure (side : Property.side) (test : Scc_chance.Answer.bound) format =
  let without_spaces text = String.concat "" (String.split_on_char ' ' text) in
  let asked bound =
    Printf.sprintf "%s%s [%s]" measure (without_spaces (Scc_chance.Answer.bound_to_string bound)) format
  in
  match (side, test.relation) with
  | Least, (At_least_so | More) | Greatest, (At_most | Less) -> asked test
  | Least, At_most -> Printf.sprintf "!(%s)" (asked { test with relation = More })
  | Least, Less -> Printf.sprintf "!(%s)" (asked { test with relation = At_least_so })
  | Greatest, At_least_so -> Printf.sprintf "!(%s)" (asked { test with relation = Less })
  | Greatest, More -> Printf.sprintf "!(%s)" (asked { test with relation = At_most })

(* A path formula of all schedulers, or of some one. Where nothing is drawn, runs have probability 0 or 1. Where
   something is, what takes all of a run may have probability 0, and is there all the same. *)
let path l (q : Property.path_quantifier) shown format =
  match (q, shown) with
  | Chance { side; test }, _ -> Ok (Asked (compared "P" side test format))
  | All, _ when not l.draws -> Ok (Asked (Printf.sprintf "P>=1 [%s]" format))
  | Exists, _ when not l.draws -> Ok (Asked (Printf.sprintf "!(P<1 [%s])" format))
  | All, By_its_absence -> Ok (Asked (Printf.sprintf "P>=1 [%s]" format))
  | Exists, By_a_prefix -> Ok (Asked (Printf.sprintf "!(P<=0 [%s])" format))
  | All, By_a_prefix | Exists, By_its_absence -> Error "it speaks of runs of probability 0, too"

let rec ask l (f : Property.temporal) =
  match Formula.state_formula f with
  | Some p -> state l p
  | None -> (
      match f with
      | State p -> state l p
      | Temporal_not f -> Result.map not_ (ask l f)
      | Temporal_and fs -> Result.map (several " & " ~neutral:true) (Result.all (ask l) fs)
      | Temporal_or fs -> Result.map (several " | " ~neutral:false) (Result.all (ask l) fs)
      | Next _ -> Error "it has the operator X"
      | Finally (q, _, _) ->
        let* format = path_formula l f in
        path l q By_a_prefix format
      | Globally (q, _, _) ->
        let* format = path_formula l f in
        path l q By_its_absence format
      | Until (q, _, _, g) ->
        let* format = path_formula l f in
        let* until = path l q By_a_prefix format in
        let* g = ask l g in
        Ok (either (both (label l "right_after") g) until))

(* Of an operator without its quantifier, in a state that does not begin right after an instant. *)
and path_formula l (f : Property.temporal) =
  match f with
  | Finally (_, b, f) ->
    let* () = unbounded b in
    Result.map (fun f -> "F " ^ bracket f) (ask l f)
  | Globally (_, b, f) ->
    let* () = unbounded b in
    Result.map (fun f -> "G " ^ bracket f) (ask l f)
  | Until (_, b, f, g) ->
    let* () = unbounded b in
    let* f = ask l f in
    let* g = ask l g in
    (* A stretch that begins right after an instant has no first instant: who comes from before meets g there only
       after instants of the same stretch; at each of those themselves, g is enough (rule Until). *)
    let met = both g (either f (not_ (label l "right_after"))) in
    Ok (Printf.sprintf "%s U %s" (bracket f) (bracket met))
  | State _ | Temporal_not _ | Temporal_and _ | Temporal_or _ | Next _ ->
    Error "it is no operator of time"

let formula ~occurs ~draws predicates f = Result.map text (ask { predicates; occurs; draws } f)

let word : Property.side -> string = function Least -> "min" | Greatest -> "max"

let asked_for measure sides format =
  String.concat "; " (List.map (fun side -> Printf.sprintf "%s%s=? [%s]" measure (word side) format) sides)

let elapsed = {|R{"time"}|}

let check ~occurs ~draws predicates (c : Property.check) =
  let l = { predicates; occurs; draws } in
  match c.asked with
  | Whether -> formula ~occurs ~draws predicates c.formula
  | How_likely sides -> Result.map (asked_for "P" sides) (path_formula l c.formula)
  | Expected (sides, Time_until _, test) -> (
      let* format = path_formula l c.formula in
      match (test, sides) with
      | Some test, side :: _ -> Ok (compared elapsed side test format)
      | _ -> Ok (asked_for elapsed sides format))
  | Expected (_, Events_until _, _) -> Error "it counts events"
  | Expected (_, Value_at _, _) -> Error "it is about an instant"
