open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_runs

let greatest_behaviour = 160
let greatest_list = 40
let name (m : Model.t) leaf = m.leaves.(leaf).name

let bond = Short_text.bond

(* "p and q", "p, q and r". *)
let listed names =
  match List.rev names with
  | [] -> ""
  | [ only ] -> only
  | last :: before -> String.concat ", " (List.rev before) ^ " and " ^ last

(* Who touches, rather than the first of each process; of bodies of several parts the part. *)
let who (m : Model.t) firsts hits =
  match List.concat_map (fun (h : Transition.hit) -> [ h.one; h.two ]) hits with
  | [] -> List.map (name m) firsts
  | ends ->
    let compare (i, p) (j, q) = if i = j then Int.compare p q else Int.compare i j in
    List.map (fun (leaf, part) -> m.leaves.(leaf).parts.(part).name) (List.sort_uniq compare ends)

let number ~full q = if full then Rat.to_string q else Short_text.exact q

let release ~full m (r : Transition.release) =
  bond m r.bond ^ if Rat.sign r.push = 0 then "" else " with a push of " ^ number ~full r.push

let label ?(full = false) m : Transition.label -> string = function
  | Time d -> Printf.sprintf "time passes by %s" (number ~full d)
  | Bind b ->
    Printf.sprintf "%s and %s collide and bind by %s" (name m b.one.at) (name m b.two.at) (bond m b)
  | Close b ->
    Printf.sprintf "%s and %s, of one process, bind by %s" (name m b.one.at) (name m b.two.at) (bond m b)
  | Bounce { firsts; hits } -> Printf.sprintf "%s collide and bounce" (listed (who m firsts hits))
  | Absorb { first; absorber } -> Printf.sprintf "%s hits %s and is gone" (name m first) (name m absorber)
  | Weak_split [ ({ bond = b; _ } as r) ] ->
    Printf.sprintf "%s and %s release %s" (name m b.one.at) (name m b.two.at) (release ~full m r)
  | Strong_split [ ({ bond = b; _ } as r) ] ->
    Printf.sprintf "%s and %s react and release %s" (name m b.one.at) (name m b.two.at) (release ~full m r)
  | Draw { first; given = { velocity; spin }; chance } ->
    let each (v : Vec.t) = String.concat ", " (List.map (number ~full) [ v.x; v.y; v.z ]) in
    let spin = Option.fold ~none:"" ~some:(fun w -> Printf.sprintf " and the spin (%s)" (each w)) spin in
    Printf.sprintf "%s draws the velocity (%s)%s, with probability %s" (name m first) (each velocity) spin
      (number ~full chance)
  | Lot { bond = b; decision = Chosen; _ } ->
    Printf.sprintf "%s and %s choose how to release %s" (name m b.one.at) (name m b.two.at) (bond m b)
  | Lot { bond = b; decision; chance } ->
    let what =
      match decision with
      | Kept -> "are to keep"
      | First -> "are first to release"
      | Let_go | Chosen -> "are to release"
    in
    Printf.sprintf "%s and %s %s %s, with probability %s" (name m b.one.at) (name m b.two.at) what (bond m b)
      (number ~full chance)
  | Weak_split releases ->
    Printf.sprintf "released at once: %s" (String.concat ", " (List.map (release ~full m) releases))
  | Strong_split releases ->
    Printf.sprintf "a reaction releases %s" (String.concat ", " (List.map (release ~full m) releases))

(* Cuts between code points. *)
let cut s =
  if String.length s <= greatest_behaviour then s
  else
    let rec back i = if i > 0 && Char.code s.[i] land 0xC0 = 0x80 then back (i - 1) else i in
    String.sub s 0 (back greatest_behaviour) ^ "…"

let passes ?(full = false) times d = Printf.sprintf "time passes %d times by %s" times (number ~full d)

let behaviour ~full m (l : State.leaf) =
  let text = State_json.behaviour m ~leaf:l.leaf l.behaviour in
  if full then text else cut text

let does_nothing m (p : State.process) =
  Array.for_all (fun l -> String.equal (behaviour ~full:true m l) "nil") p.leaves

let leaf ~full m (l : State.leaf) =
  Printf.sprintf "%s at %s [%s]" (name m l.leaf) (Short_text.position ~full m l) (behaviour ~full m l)

let fixed (m : Model.t) (p : State.process) =
  Array.exists (fun (l : State.leaf) -> m.leaves.(l.leaf).fixed) p.leaves

let absorbs (m : Model.t) (p : State.process) =
  Array.exists (fun (l : State.leaf) -> m.leaves.(l.leaf).absorbs) p.leaves

let motion ~full m (p : State.process) =
  if absorbs m p then "fixed, and absorbs what hits it"
  else if fixed m p then "fixed"
  else Short_text.motion ~full m p

let process ~full m (p : State.process) =
  match p.leaves with
  | [| l |] -> [ Printf.sprintf "%s, %s" (leaf ~full m l) (motion ~full m p) ]
  | leaves ->
    let bonds = Array.to_list (Array.map (bond m) p.bonds) in
    Printf.sprintf "one process, %s, %s" (motion ~full m p) (String.concat " " bonds)
    :: List.map (fun l -> "  " ^ leaf ~full m l) (Array.to_list leaves)

let most_names = 8

let names_line word names =
  let more = List.length names - most_names in
  let rest = if more > 0 then [ Printf.sprintf "%d more" more ] else [] in
  Printf.sprintf "%s: %s" word (listed (List.filteri (fun i _ -> i < most_names) names @ rest))

let aside_line m (word, ps) =
  let name_of (p : State.process) =
    String.concat "+" (Array.to_list (Array.map (fun (l : State.leaf) -> name m l.leaf) p.leaves))
  in
  names_line word (List.map name_of ps)

(* One that is named instead of told takes the same line. *)
let least_aside = 2

let state ?(full = false) ?(aside = fun _ -> None) m (s : State.t) =
  let all = Array.to_list s.processes in
  let placed = List.map (fun p -> ((if full then None else aside p), p)) all in
  let named = List.length (List.filter (fun (word, _) -> Option.is_some word) placed) in
  let placed = if named < least_aside then List.map (fun p -> (None, p)) all else placed in
  let told = List.filter_map (fun (word, p) -> if Option.is_none word then Some p else None) placed in
  let n = List.length told in
  let shown = if full then told else List.filteri (fun i _ -> i < greatest_list) told in
  let more = n - List.length shown in
  let words = List.fold_left (fun ws (w, _) -> if List.mem w ws then ws else w :: ws) [] placed in
  let group word =
    Option.map (fun w -> (w, List.filter_map (fun (v, p) -> if v = word then Some p else None) placed)) word
  in
  let lines = if all = [] then [ "no process" ] else List.concat_map (process ~full m) shown in
  lines
  @ (if more > 0 then [ Printf.sprintf "… and %d more processes" more ] else [])
  @ List.map (aside_line m) (List.filter_map group (List.rev words))
  @ match State.gone m s with [] -> [] | gone -> [ names_line "gone" (List.map (name m) gone) ]

(* A few digits of what may take thousands: the JSON has them all. *)
let brief q =
  let exact = Rat.to_string q in
  if String.length exact <= 12 then exact else Decimal.significant ~digits:6 q

(* Of bounds that are less than 2^-100 apart, the lower one says enough. *)
let rounded ((t : Scc_engine.Totals.t), _) =
  let vector (v : Vec.t) = Printf.sprintf "(%s, %s, %s)" (brief v.x) (brief v.y) (brief v.z) in
  [
    "rounding has added, to six digits (the JSON tells more):";
    "  to the momentum " ^ vector t.momentum;
    "  to the angular momentum about the origin " ^ vector t.angular;
    "  to the kinetic energy " ^ brief t.energy;
  ]
