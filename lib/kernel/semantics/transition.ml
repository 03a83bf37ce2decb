open Scc_exact
open Scc_calculus

type hit = { one : int * int; two : int * int }

type release = { bond : State.bond; push : Rat.t }

type decision = Kept | Let_go | First | Chosen

type label =
  | Time of Rat.t
  | Bind of State.bond
  | Close of State.bond
  | Bounce of { firsts : int list; hits : hit list }
  | Absorb of { first : int; absorber : int }
  | Weak_split of release list
  | Strong_split of release list
  | Draw of { first : int; given : Given.t; chance : Rat.t }
  | Lot of { bond : State.bond; decision : decision; chance : Rat.t }

type outcome = {
  rule : Rule.t;
  label : label;
  fired : Behaviours.derivation list list;
  gone : State.process list;
  come : State.process list;
}

let rules o =
  let used = match o.fired with [] -> [] | first :: _ -> List.concat_map Behaviours.rules first in
  o.rule :: List.filter (fun r -> List.memq r used) Rule.all

type t = {
  label : label;
  rules : Rule.t list;
  fired : Behaviours.derivation list list;
  target : State.t;
  chance : Rat.t option;
  rounded : State.t option;
}
type fault =
  | Bad_chance of State.finish
  | Bad_law of { leaf : int; fault : Law.fault }
  | Persistent_contact of int list

let bonds = function
  | Time _ | Bounce _ | Absorb _ | Draw _ | Lot _ -> []
  | Bind b | Close b -> [ b ]
  | Weak_split releases | Strong_split releases -> List.map (fun r -> r.bond) releases

let duration_of = function
  | Time d -> d
  | Bind _ | Close _ | Bounce _ | Absorb _ | Weak_split _ | Strong_split _ | Draw _ | Lot _ -> Rat.zero

let is_time = function
  | Time _ -> true
  | Bind _ | Close _ | Bounce _ | Absorb _ | Weak_split _ | Strong_split _ | Draw _ | Lot _ -> false

let is_drawn = function
  | Draw _ | Lot { decision = Kept | Let_go | First; _ } -> true
  | Lot { decision = Chosen; _ }
  | Time _ | Bind _ | Close _ | Bounce _ | Absorb _ | Weak_split _ | Strong_split _ -> false

let is_urgent = function
  | Strong_split _ | Close _ | Bind _ | Bounce _ | Absorb _ | Draw _ | Lot _ -> true
  | Time _ | Weak_split _ -> false

let chance = function
  | Draw { chance; _ } | Lot { chance; _ } -> chance
  | Time _ | Bind _ | Close _ | Bounce _ | Absorb _ | Weak_split _ | Strong_split _ -> Rat.one

let duration (t : t) = duration_of t.label

let equal_release r s = State.equal_bond r.bond s.bond && Rat.equal r.push s.push

let compare_ends (i, p) (j, q) =
  Int.compare i j <?> fun () -> Int.compare p q

let hit a b = if compare_ends a b <= 0 then { one = a; two = b } else { one = b; two = a }

let compare_hit a b =
  compare_ends a.one b.one <?> fun () -> compare_ends a.two b.two

let equal_label a b =
  match (a, b) with
  | Time s, Time t -> Rat.equal s t
  | Bind x, Bind y | Close x, Close y -> State.equal_bond x y
  | Bounce x, Bounce y ->
    List.equal Int.equal x.firsts y.firsts && List.equal (fun a b -> compare_hit a b = 0) x.hits y.hits
  | Absorb x, Absorb y -> Int.equal x.first y.first && Int.equal x.absorber y.absorber
  | Weak_split x, Weak_split y | Strong_split x, Strong_split y -> List.equal equal_release x y
  | Draw x, Draw y -> Int.equal x.first y.first && Given.equal x.given y.given && Rat.equal x.chance y.chance
  | Lot x, Lot y -> State.equal_bond x.bond y.bond && x.decision = y.decision && Rat.equal x.chance y.chance
  | (Time _ | Bind _ | Close _ | Bounce _ | Absorb _ | Weak_split _ | Strong_split _ | Draw _ | Lot _), _ -> false

let renamed image label =
  let finish (f : State.finish) = { f with at = image f.at } in
  let bond (b : State.bond) = State.bond b.name (finish b.one) (finish b.two) in
  let release r = { r with bond = bond r.bond } in
  let named (leaf, part) = (image leaf, part) in
  let by_bond r s = State.compare_bond r.bond s.bond in
  let all releases = List.sort by_bond (List.map release releases) in
  match label with
  | Time _ -> label
  | Bind b -> Bind (bond b)
  | Close b -> Close (bond b)
  | Bounce { firsts; hits } ->
    let hits = List.map (fun h -> hit (named h.one) (named h.two)) hits in
    Bounce { firsts = List.sort Int.compare (List.map image firsts); hits = List.sort compare_hit hits }
  | Absorb { first; absorber } -> Absorb { first = image first; absorber = image absorber }
  | Weak_split releases -> Weak_split (all releases)
  | Strong_split releases -> Strong_split (all releases)
  | Draw d -> Draw { d with first = image d.first }
  | Lot l -> Lot { l with bond = bond l.bond }

let same (a : outcome) (b : outcome) =
  equal_label a.label b.label && List.equal State.equal_process a.come b.come

let add (o : outcome) =
  Scc_data.Lists.put (fun kept -> if same kept o then Some { kept with fired = kept.fired @ o.fired } else None) o

let distinct outcomes = List.fold_left (fun kept o -> add o kept) [] outcomes

let finish_to_string m (f : State.finish) = Model.site_name m ~leaf:f.at f.site
let ends m (b : State.bond) = finish_to_string m b.one ^ ", " ^ finish_to_string m b.two
let bond_to_string m (b : State.bond) = Printf.sprintf "%s, %s" b.name (ends m b)

let pushed r = if Rat.sign r.push = 0 then "" else Printf.sprintf " push(%s)" (Rat.to_string r.push)

let names (m : Model.t) = List.map (fun i -> m.leaves.(i).name)

let time_of_string text =
  let n = String.length text in
  if n > 6 && String.equal (String.sub text 0 5) "time(" && text.[n - 1] = ')' then
    match Rat.of_literal (String.sub text 5 (n - 6)) with Ok d -> Some d | Error _ -> None
  else None

let decision_to_string = function Kept -> "keep" | Let_go -> "release" | First -> "first" | Chosen -> "choose"

let set_to_string m releases =
  let one ({ bond = b; _ } as r) = Printf.sprintf "<%s, {%s}>%s" b.name (ends m b) (pushed r) in
  Printf.sprintf "({%s})" (String.concat ", " (List.map one releases))

let label_to_string (m : Model.t) = function
  | Time d -> Printf.sprintf "time(%s)" (Rat.to_string d)
  | Bind b -> Printf.sprintf "bind(%s, %s)" b.name (ends m b)
  | Close b -> Printf.sprintf "close(%s, %s)" b.name (ends m b)
  | Bounce { firsts; _ } -> Printf.sprintf "bounce(%s)" (String.concat ", " (names m firsts))
  | Absorb { first; absorber } ->
    Printf.sprintf "absorb(%s)" (String.concat ", " (names m [ first; absorber ]))
  | Weak_split [ r ] -> Printf.sprintf "weak(%s)%s" (bond_to_string m r.bond) (pushed r)
  | Weak_split releases -> "weak" ^ set_to_string m releases
  | Strong_split releases -> "strong" ^ set_to_string m releases
  | Draw { first; given; chance } ->
    Printf.sprintf "draw(%s, %s) chance(%s)" m.leaves.(first).name (Given.to_string given) (Rat.to_string chance)
  | Lot { bond = b; decision = Chosen; _ } -> Printf.sprintf "choose(%s)" (bond_to_string m b)
  | Lot { bond = b; decision; chance } ->
    Printf.sprintf "%s(%s) chance(%s)" (decision_to_string decision) (bond_to_string m b) (Rat.to_string chance)

let of_fault (m : Model.t) fault =
  match fault with
  | Bad_chance f ->
    Scc_base.Diag.error Scc_base.Code.bad_chance Scc_base.Span.none
      "the chances with which `%s` releases a bond at %s sum to more than 1" m.leaves.(f.at).name
      (Model.site_name m ~leaf:f.at f.site)
      ~hint:"each is the probability of one way to release it, and at most one of them happens"
  | Bad_law { leaf; fault } ->
    Scc_base.Diag.error Scc_base.Code.bad_law m.leaves.(leaf).law_at
      "the law of motion of %s cannot be evaluated: %s" m.leaves.(leaf).name
      (match fault with
       | Division_by_zero -> "it divides by zero"
       | Bad_quantum -> "it rounds to a quantum that is not positive"
       | Too_long -> Printf.sprintf "it makes a number of more than %d bits" Law.longest
       | Negative_weight -> "a weight is negative"
       | No_weight -> "the weights of all its velocities are 0"
       | Too_many -> Printf.sprintf "a whole draws among more than %d velocities" Law.most_outcomes)
  | Persistent_contact firsts ->
    Scc_base.Diag.error Scc_base.Code.persistent_contact Scc_base.Span.none
      "persistent contact: %s would interpenetrate at once, though they do not approach where they touch"
      (String.concat " and " (names m firsts))

let diagnostic ?at (m : Model.t) fault =
  let d = of_fault m fault in
  match at with
  | None | Some [||] -> d
  | Some values ->
    { d with message = Printf.sprintf "%s, for %s" d.message (Ranges.values_to_string m.ranges values) }
