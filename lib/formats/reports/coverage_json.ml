open Scc_calculus
open Scc_verify
open Scc_json
open Scc_runs

let on (m : Model.t) definition species = Printf.sprintf "%s on %s" m.definitions.(definition).name species

let owner (m : Model.t) (s : Coverage.summand) =
  let leaf = m.leaves.(s.leaf) in
  match s.definition with
  | Some k -> on m k leaf.template
  | None -> leaf.name

let term m (s : Coverage.summand) = Behaviour_text.to_string m ~leaf:s.leaf s.term
let behaviour m (b : Coverage.behaviour) = on m b.definition b.species

let summand (m : Model.t) (s : Coverage.summand) =
  let name k = Json.text m.definitions.(k).name in
  `Assoc
    [
      ("behaviour", Json.option name s.definition);
      ("body", Json.text m.leaves.(s.leaf).name);
      ("term", Json.text (term m s));
      ("fired", `Int s.fired);
    ]

let reached (m : Model.t) (b : Coverage.behaviour) =
  `Assoc
    [
      ("behaviour", Json.text m.definitions.(b.definition).name);
      ("species", Json.text b.species);
      ("body", Json.text m.leaves.(b.leaf).name);
      ("reached", `Bool b.reached);
    ]

let channel (c : Coverage.channel) =
  `Assoc
    [ ("name", Json.text c.name); ("made", `Int c.made); ("weak", `Int c.weak); ("strong", `Int c.strong) ]

let json (s : Explored.t) c =
  let m = Explored.model s in
  let rule (r, n) = (Scc_semantics.Rule.id r, `Int n) in
  `Assoc
    [
      ("states", `Int s.size);
      ("looked_at", `Int (Coverage.looked_at c));
      ("complete", `Bool (Coverage.looked_at c = s.size));
      ("summands", `List (List.map (summand m) (Coverage.summands c)));
      ("behaviours", `List (List.map (reached m) (Coverage.behaviours c)));
      ("channels", `List (List.map channel (Coverage.channels c)));
      ("rules", `Assoc (List.map rule (Coverage.rules c)));
    ]
