open Scc_geometry
open Scc_calculus

type candidate = { bond : State.bond; continuations : (int * Behaviour.t) list; used : Rule.t list }

let open_channels (m : Model.t) (p : State.process) leaf =
  Behaviour.derivations m.definitions (State.leaf_of p leaf).behaviour
  |> List.filter_map (fun (offer, derivation) ->
      match offer with
      | Behaviour.Offer_open (polarity, channel, b) ->
        Some (polarity, channel, b, Process.rules Rule.Pre derivation)
      | Offer_weak _ | Offer_strong _ -> None)

let complementary a b =
  match (a, b) with
  | Behaviour.Name, Behaviour.Co_name | Co_name, Name -> true
  | Name, Name | Co_name, Co_name -> false

(* The touching pairs that two channels share, of the highest dimension among them. *)
let shared_pairs pairs ~active_one ~active_two =
  let shared =
    List.filter (fun (c : Contact.pair) -> active_one c.first && active_two c.second) pairs
  in
  let highest = List.fold_left (fun d (c : Contact.pair) -> max d c.dimension) 0 shared in
  List.filter (fun (c : Contact.pair) -> c.dimension = highest) shared

let candidates m p q ~one:(l1, part1) ~two:(l2, part2) touching =
  let site part feature : Site.t = { part; feature } in
  let ones = open_channels m p l1 and twos = open_channels m q l2 in
  if ones = [] || twos = [] then []
  else
    let pairs = touching () in
    let meet (pol1, (c1 : Behaviour.channel), b1, r1) (pol2, (c2 : Behaviour.channel), b2, r2) =
      if not (complementary pol1 pol2 && String.equal c1.name c2.name) then []
      else
        shared_pairs pairs
          ~active_one:(fun f -> Behaviour.active c1 (site part1 f))
          ~active_two:(fun f -> Behaviour.active c2 (site part2 f))
        |> List.map (fun (c : Contact.pair) ->
            {
              bond =
                State.bond c1.name
                  { at = l1; site = site part1 c.first }
                  { at = l2; site = site part2 c.second };
              continuations = [ (l1, b1); (l2, b2) ];
              used = Process.union r1 r2;
            })
    in
    List.concat_map (fun one -> List.concat_map (meet one) twos) ones

let joined m (p : State.process) (q : State.process) candidate =
  let leaves =
    Array.to_list (Array.append p.leaves q.leaves) |> List.map (Process.continue candidate.continuations)
  in
  let bonds = candidate.bond :: Array.to_list (Array.append p.bonds q.bonds) in
  Process.restart_clock m (State.process ~leaves ~bonds ~velocity:Scc_exact.Vec.zero ~clock:None ())
