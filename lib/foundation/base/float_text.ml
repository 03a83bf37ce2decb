let shortest x =
  if Float.is_integer x && Float.abs x < 1e15 then Printf.sprintf "%.0f.0" x
  else
    let rec with_digits n =
      let s = Printf.sprintf "%.*g" n x in
      if n = 17 || Float.equal (float_of_string s) x then s else with_digits (n + 1)
    in
    with_digits 15
