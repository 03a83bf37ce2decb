let count n one many = if n = 1 then "1 " ^ one else Printf.sprintf "%d %s" n many
