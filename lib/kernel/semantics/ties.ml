open Scc_exact
open Scc_calculus

module Who = Map.Make (struct
    type t = int list

    let compare = List.compare Int.compare
  end)

type bond = { name : string; ends : int * int; behaviours : Behaviour.aged list }
type deed = { who : int list; bond : bond option }

let first (p : State.process) = p.leaves.(0).leaf

let deed (o : Transition.outcome) =
  let bond (b : State.bond) =
    let behaviour at =
      let whole = List.find (fun p -> State.has_leaf p at) o.come in
      (State.leaf_of whole at).behaviour
    in
    Some { name = b.name; ends = (b.one.at, b.two.at); behaviours = [ behaviour b.one.at; behaviour b.two.at ] }
  in
  let who = List.sort Int.compare (List.map first o.gone) in
  match o.label with
  | Bind b | Close b -> { who; bond = bond b }
  | Absorb { absorber; _ } -> { who = List.sort Int.compare (absorber :: who); bond = None }
  | Time _ | Bounce _ | Weak_split _ | Strong_split _ | Draw _ | Lot _ -> { who; bond = None }

(* They differ at most in the features of the bond. *)
let alike a b =
  match (a.bond, b.bond) with
  | Some x, Some y ->
    String.equal x.name y.name && x.ends = y.ends && List.equal Behaviour.equal_aged x.behaviours y.behaviours
  | None, _ | _, None -> a == b

let share ~groups own d =
  let first_of_kind (kinds, before) d = ((if List.exists (alike d) before then kinds else kinds + 1), d :: before) in
  let kinds, _ = List.fold_left first_of_kind (0, []) own in
  Rat.make Z.one (Z.of_int (groups * kinds * List.length (List.filter (alike d) own)))

let odds all =
  let add by_who d = Who.update d.who (fun known -> Some (d :: Option.value known ~default:[])) by_who in
  let by_who = List.fold_left add Who.empty all in
  match all with
  | [] | [ _ ] -> fun _ -> None
  | _ -> fun d -> Some (share ~groups:(Who.cardinal by_who) (Who.find d.who by_who) d)

type source = { below : int -> int; by_chance : Rat.t list -> int }
type tie = { others : int list; pick : source -> int }

let same_processes a b = List.equal Int.equal a.who b.who

(* An index is drawn again until it is the first of its processes, so that these are as probable as each other. *)
let rec pick source n deed =
  let i = source.below n in
  let here = deed i in
  if i > 0 && same_processes (deed (i - 1)) here then pick source n deed
  else
    let rec from j found =
      if j = n then List.rev found
      else
        let d = deed j in
        if same_processes here d then from (j + 1) (d :: found) else List.rev found
    in
    match from (i + 1) [ here ] with
    | [ _ ] -> i
    | own -> i + source.by_chance (List.map (share ~groups:1 own) own)
