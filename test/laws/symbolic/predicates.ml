open Scc_exact
open Scc_calculus
open Scc_property
module Gen = QCheck2.Gen

let comparison = Gen.oneofl [ Law.Lt; Le; Eq; Ge; Gt; Ne ]

let rec predicate leaves ~timed depth : Property.prop Gen.t =
  let open Gen in
  let leaf = 0 -- (leaves - 1) and axis = oneofl [ Vec.X; Y; Z ] in
  let two = map (fun i -> (i, (i + 1) mod leaves)) leaf in
  let small = map (fun n -> Property.Const (Rat.make (Z.of_int n) (Z.of_int 2))) (-4 -- 12) in
  let compare a b = map3 (fun op a b -> Property.Compare (op, a, b)) comparison a b in
  let quantity q = Property.Quantity q in
  let position = map2 (fun a i -> quantity (Position (a, i))) axis leaf in
  let velocity = map2 (fun a i -> quantity (Velocity (a, i))) axis leaf in
  let fact f = Property.Fact f in
  let atoms =
    [
      (2, map (fun (i, j) -> fact (Bound (i, j))) two);
      (1, map (fun (i, j) -> fact (Same (i, j))) two);
      (2, map (fun (i, j) -> fact (Touching (i, j))) two);
      (1, map (fun i -> fact (Gone i)) leaf);
      (1, map (fun i -> fact (Behaviour (i, i))) leaf);
      (1, map (fun i -> fact (Offers (i, None, "a"))) leaf);
      (1, pure (fact Quiescent));
      (2, compare velocity (map (fun n -> Property.Const (Rat.of_int n)) (-1 -- 1)));
      (2, compare position small);
      (2, compare position position);
      (1, map (fun i -> fact (Event (Bounce (One i)))) leaf);
      (1, map (fun (i, j) -> fact (Event (Bond (Made, None, Two (i, j))))) two);
      (1, map (fun i -> fact (Event (Bond (Released, None, One i)))) leaf);
      (1, map (fun i -> fact (Event (Hit ({ leaf = i; part = None }, None)))) leaf);
    ]
    @ if timed then [ (2, compare (pure (quantity Time)) small) ] else []
  in
  if depth = 0 then frequency atoms
  else
    let below = predicate leaves ~timed (depth - 1) in
    frequency
      [
        (1, frequency atoms);
        (1, map (fun p -> Property.Not p) below);
        (2, map2 (fun p q -> Property.And [ p; q ]) below below);
        (1, map2 (fun p q -> Property.Or [ p; q ]) below below);
      ]

let generate leaves ~timed depth = predicate leaves ~timed depth
