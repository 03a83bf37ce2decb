open Scc_exact

let check ~path at ~category ~factor =
  let factor = Scene.ok (Text.coordinate ~path factor) in
  if String.equal category "angle" && not (Rat.equal factor Rat.one) then
    Scene.unread ~path at ~hint:"write the angles in radians, and remove the unit"
      "angles in another unit are not read"
