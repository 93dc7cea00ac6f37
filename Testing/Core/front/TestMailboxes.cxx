// SPDX-License-Identifier: BSD-3-Clause
// The mail between districts.
#include "front/Mailboxes.h"

#include <gtest/gtest.h>

#include <vector>

using geodesic::Id;
using geodesic::MailBatch;
using geodesic::Mailboxes;

TEST(Mailboxes, DeliverTheMailOfManyDistrictsInTheirOrder)
{
  constexpr Id districts = 200;
  Mailboxes post(districts);
  std::vector<Id> senders;
  for (Id sender = 3; sender < districts; sender += 7)
  {
    post.to(sender, 5).updates.resize(sender);
    post.to(5, sender).updates.resize(1);
    senders.push_back(sender);
  }
  std::vector<Id> found;
  post.forEach(5,
    [&](MailBatch& mail)
    {
      if (!mail.isEmpty()) // it always has a slot for itself
      {
        found.push_back(static_cast<Id>(mail.updates.size()));
      }
    });
  EXPECT_EQ(found, senders);
  post.clear(5);
  post.forEach(5, [](const MailBatch& mail) { EXPECT_TRUE(mail.isEmpty()); });

  std::vector<Id> receivers;
  post.takeReceivers(receivers);
  senders.insert(senders.begin() + 1, 5);
  EXPECT_EQ(receivers, senders);
  post.takeReceivers(receivers);
  EXPECT_TRUE(receivers.empty());
}
