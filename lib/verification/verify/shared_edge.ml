open Scc_geometry
open Scc_calculus
open Scc_semantics
open Scc_state_space

(* The features that a leaf ever opens, with their closures, under whichever name, as far as its text tells. *)
let opened (m : Model.t) (l : State.leaf) =
  let seen = Array.make (Array.length m.definitions) false in
  let rec within found (b : Behaviour.t) =
    match b with
    | Open (_, c, rest) -> within (c.sites @ found) rest
    | Call k when seen.(k) -> found
    | Call k ->
      seen.(k) <- true;
      within found m.definitions.(k).body
    | Nil | Weak _ | Strong _ | Delay _ | Wait _ | Sum _ -> List.fold_left within found (Behaviour.parts b)
  in
  List.sort_uniq Site.compare (within [] l.behaviour.term)

let sharing (m : Model.t) (initial : State.t) (f : State.finish) =
  let of_leaf (p : State.process) = opened m (State.leaf_of p f.at) in
  let listed = Option.fold ~none:[] ~some:of_leaf (State.home initial f.at) in
  let has (s : Site.t) =
    let solid = m.leaves.(f.at).parts.(s.part).solid in
    s.part = f.site.part
    && List.exists (Feature.equal f.site.feature) (Polyhedron.closure solid.polyhedron [ s.feature ])
  in
  if List.exists (Site.equal f.site) listed then []
  else match List.filter has listed with [] | [ _ ] -> [] | several -> several

let of_end m initial name (f : State.finish) =
  match sharing m initial f with
  | [] -> None
  | sites ->
    let text site = Model.site_name m ~leaf:f.at site in
    Some
      (Scc_base.Diag.warning Scc_base.Code.shared_edge Scc_base.Span.none
         "a bond `%s` was made on %s, which belongs to %s: all are open, and so are their edges and corners"
         name (text f.site)
         (String.concat " and " (List.map text sites))
         ~hint:"`only` before a feature leaves these out, as in `<a, {only top, only left}>`")

let warning context =
  let m = Network_lts.model context and initial = Network_lts.start context in
  let of_label : Transition.label -> Scc_base.Diag.t option = function
    | Bind b | Close b -> List.find_map (of_end m initial b.name) [ b.one; b.two ]
    | Time _ | Bounce _ | Absorb _ | Weak_split _ | Strong_split _ | Draw _ | Lot _ -> None
  in
  let labels = Catalogue.labels (Network_lts.catalogue context) in
  match List.sort Scc_base.Diag.compare (List.filter_map of_label labels) with
  | [] -> None
  | first :: _ -> Some first
