open Scc_exact

type t = { mutable given : (string * Rat.t) list }

let none () = { given = [] }

let state t ~path (at : Text.word) ~category ~factor =
  let written = factor.Text.text in
  let word = factor in
  let factor = Scene.ok (Text.coordinate ~path word) in
  if not (List.mem category [ "angle"; "force"; "length"; "mass" ]) then
    Scene.bad ~path at "X3D has units of angle, force, length and mass, and none of %s" (Text.quote category);
  if Rat.sign factor <= 0 then
    Scene.bad ~path word "a unit has to be more than 0, and this is %s" (Text.quote written);
  if List.mem_assoc category t.given then Scene.bad ~path at "the unit of %s is there twice" category;
  if String.equal category "angle" && not (Rat.equal factor Rat.one) then
    Scene.unread ~path at ~hint:"write the angles in radians, and remove the unit"
      "angles in another unit are not read";
  t.given <- (category, factor) :: t.given

let length t = Option.value (List.assoc_opt "length" t.given) ~default:Rat.one
