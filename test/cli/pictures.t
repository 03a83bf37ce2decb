The pictures of the guide are those that scc draws.

  $ scc check ../../specs/models/meeting.sc --draw meeting.svg > /dev/null
  [1]
  $ cmp ../../specs/pictures/meeting.svg meeting.svg
